#pragma once

#include <FoamSim/scenes/catalogue.h>

/// The models of this program, each in the file of its name: entries for a catalogue.
foamsim::SceneEntry egg_scene();
foamsim::VertexAreaEntry smallest_area();
foamsim::EffectEntry wind();

#pragma once

#include <Eigen/Core>

#include "FoamSim/render/camera.h"
#include "FoamSim/render/image.h"
#include "FoamSim/render/surface.h"

namespace foamsim::render {

/// What is seen where nothing is drawn.
enum class Background {
  dark,         ///< a dark blue-grey studio backdrop, lighter in the middle
  white,        ///< pure white, for print
  transparent,  ///< an alpha channel; opacity is what the films do not let through
};

/// How a picture is made. The defaults give a figure of translucent soap films.
struct RenderOptions {
  /// Size, pixels, 1 … 32768 each.
  int width = 800;
  int height = 600;
  /// Most rays a pixel, 1 … 4096; one suffices where the pixels around have the same light, and four where neither they
  /// nor those around differ by what can be seen.
  int samples = 16;
  Background background = Background::dark;

  /// Mean film thickness, nm, in (0, 1500]; sets the interference colours.
  double film_thickness = 380;
  /// Relative spread of the thickness (thinner on top, soft noise), in [0, 1].
  double thickness_variation = 0.5;
  /// Strength of the interference colours: 0 grey reflections, 1 physical.
  double iridescence = 0.5;
  /// Optical depth of one film crossed at a right angle (a faint bluish haze that makes films visible), ≥ 0; 0: clear.
  double film_density = 0.035;
  /// Part of the light behind a film with colours of its own that it takes, seen at a right angle, in [0, 1).
  double color_opacity = 0.5;
  /// Films reflect other films (one bounce) rather than only the studio.
  bool interreflection = true;

  /// Radius of the Plateau-border tubes over half the picture's height at the target, ≥ 0; 0: no tubes. Where the mesh
  /// is so fine that this would hide it, 0.3 mean edge lengths is used instead.
  double tube_radius = 0.009;
  /// Draw free edges of films (wires, rims of hidden patches) as tubes too.
  bool boundary_tubes = true;

  /// Overlay the triangles' edges.
  bool wireframe = false;
  /// Width of the overlaid lines, pixels.
  double wireframe_width = 1.0;

  /// Factor on all light, > 0.
  double exposure = 1;
};

/// Draws the films of `surface` seen by `camera`.
///
/// Each ray is followed straight through all films, front to back (films are far too thin to bend it). Each film
/// reflects the Airy reflectance of a water layer in air, integrated over the visible spectrum (see film_optics.h), of
/// a procedural studio, and lets the rest through. Normals are interpolated within a film and never across a Plateau
/// border. Edges with three or more visible triangles are drawn as tubes, smoothly from one to the next. Triangles of
/// zero area are skipped.
///
/// Uses the ambient TBB arena. The same input gives the same bits for any number of threads.
/// @throws base::InputError  if the surface has no triangles, its arrays disagree, an index is out of range, a
///         position is not finite, or a camera or option value is out of range.
Image render(const Surface& surface, const Camera& camera, const RenderOptions& options = {});

/// The same with the camera of `framing` for this surface and picture size.
Image render(const Surface& surface, const RenderOptions& options = {});

}  // namespace foamsim::render

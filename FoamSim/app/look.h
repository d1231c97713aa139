#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "Base/console/command.h"
#include "FoamSim/render/camera.h"
#include "FoamSim/render/colors.h"
#include "FoamSim/render/cut.h"
#include "FoamSim/render/render.h"

namespace foamsim::app {

/// How frames are drawn.
struct Look {
  render::RenderOptions options;
  render::FramingOptions framing;
  std::optional<Eigen::Vector3d> eye, target;  ///< L; none: by framing
  std::optional<render::CutPlane> cut;
  double explode = 0;
  std::string color = "interference";       ///< or regions, or the name of a field
  std::optional<render::FieldRange> range;  ///< none: of the field in all frames
  bool scale_bar = false;

  bool has_field() const { return color != "interference" && color != "regions"; }
};

/// What the command line says of it, as typed.
struct LookArguments {
  std::string size = "800x600", background = "dark", color = "interference";
  std::vector<double> view{0.514, 0.242, 0.823}, eye, target, cut, range;
  double zoom = 1, explode = 0;
  bool scale_bar = false;
  render::RenderOptions options;

  /// Refers to itself: it has to outlive the command.
  void add_to(base::Command& command);
  /// Throws base::InputError for what cannot be drawn.
  Look look() const;
};

/// Draws several frames alike: with one camera that shows all of them, and one range of the field.
class Painter {
 public:
  /// Reads every frame once. `all_around`: the camera will go round. Throws base::InputError where a frame cannot be
  /// read or drawn.
  Painter(Look look, std::span<const std::filesystem::path> frames, bool all_around);

  /// A frame with legend and scale; the camera has gone round by so many degrees.
  render::Image draw(const std::filesystem::path& frame, double degrees = 0) const;

 private:
  render::Surface surface_of(const std::filesystem::path& frame) const;

  Look look_;
  render::FieldRange range_;
  render::Camera camera_;
};

}  // namespace foamsim::app

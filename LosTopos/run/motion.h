#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "LosTopos/io/film_faces.h"
#include "LosTopos/run/step_work.h"

namespace lostopos::run {

/// A table that grows with a run: one or several rows every so many steps, from the start on.
struct Table {
  std::string file;    ///< its name in the run's folder
  std::string header;  ///< names of columns, the first of which is the step
  long every = 1;      ///< steps between rows, ≥ 1
  /// The lines of the motion as it is now, each with its newline; empty when there is nothing to say.
  std::function<std::string()> rows;
};

/// Something that moves a surface step by step, and measures it: what a run runs.
class Motion {
 public:
  Motion() = default;
  Motion(const Motion&) = delete;
  Motion& operator=(const Motion&) = delete;
  virtual ~Motion() = default;

  /// One step, measured. Throws base::Error when the surface cannot go on (the run then ends as failed),
  /// base::Interrupted when it has been asked to stop, the motion being as before the step, or base::InputError for
  /// what no run can go on with (thrown on).
  virtual void step() = 0;
  /// Steps since the start of the motion, those before a checkpoint included.
  virtual long steps() const = 0;
  virtual double time() const = 0;  ///< T
  virtual const SurfaceMesh& mesh() const = 0;
  /// What the last step did.
  virtual const StepWork& last() const = 0;

  /// The tables that a run of this motion writes.
  virtual std::vector<Table> tables() const { return {}; }
  /// The surface as a frame holds it.
  virtual SurfaceData frame() const { return from_mesh_with_solids(mesh()); }
  /// The surface with its arrays, for vtp files: see film_picture.
  virtual SurfaceData picture() const { return film_picture(from_mesh(mesh())); }
  /// The surface as a .rec file holds it: with circulation and what is held, where there are such.
  virtual SurfaceData record() const { return from_mesh(mesh()); }
  /// Whether it can be taken up again from a checkpoint.
  virtual bool resumable() const { return false; }
  /// Puts what it needs to go on as if it had not stopped, to the bit, into an empty object.
  virtual void save(nlohmann::json& /*checkpoint*/) const {}
  /// Adds what run.json says besides what it says of every run.
  virtual void summarize(nlohmann::ordered_json& /*run*/) const {}
};

}  // namespace lostopos::run

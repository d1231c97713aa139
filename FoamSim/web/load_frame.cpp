#include "FoamSim/web/load_frame.h"

#include "FoamSim/web/gzip.h"
#include "LosTopos/io/mesh_file.h"

namespace foamsim::web {

LoadedFrame load_frame(const RunFrame& frame, const FrameOptions& options) {
  const lostopos::SurfaceData surface =
      lostopos::read_surface(frame.with_fields.empty() ? frame.surface : frame.with_fields);
  const SurfaceMeasures measures = measure(surface);
  const std::vector<FrameField> fields = chosen_fields(fields_of(surface, measures), options.fields);
  return {gzip(pack_frame(surface, measures, fields, frame.step, frame.time, options.precision)),
          bubbles_json(measures.bubbles), surface.triangles.size()};
}

}  // namespace foamsim::web

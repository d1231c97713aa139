#include "LosTopos/reference_options.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "Base/error.h"
#include "Base/io/file_size.h"
#include "Base/names/nearest_name.h"

namespace lostopos {

using base::OptionSet;
using base::OptionValue;

std::vector<ReferenceKey> tracker_reference_keys(bool plain_tracking) {
  using enum KeyUse;
  return {
      {"remeshing-resolution", "0.1", converted, plain_tracking ? "resolution" : "resolution, resolution_mean",
       plain_tracking ? "0: the mean edge; there of all triangles' sides, so that an inner edge counts twice"
                      : "0: the mean over all triangles of their three sides, so that an inner edge counts twice and a "
                        "Plateau border three times"},
      {"remeshing-iterations", "1", converted, "remeshing.iterations, remeshing.enabled, topology.enabled",
       "0: neither remeshing nor topology changes; the reference changes the topology in each iteration, here it is "
       "done once a step"},
      {"lostopos-collision-epsilon-fraction", "1e-4", as_it_is, "tracker.proximity", ""},
      {"lostopos-merge-proximity-epsilon-fraction", plain_tracking ? "0.02" : "0.1", as_it_is,
       "topology.merge_distance", ""},
      {"lostopos-perform-smoothing", "0", converted, "remeshing.smooth_below",
       "1: 60, all vertices are smoothed; 0: 30, those of triangles with a smaller angle are, without which slivers "
       "stay "
       "here that do not there (tet.txt breaks up, bubblewand.txt's volume is off by 3.7% in place of 0.6%)"},
      {"lostopos-max-volume-change-fraction", plain_tracking ? "1e-4" : "1e-2", as_it_is, "remeshing.max_volume_change",
       ""},
      {"lostopos-min-triangle-angle", "3", as_it_is, "remeshing.min_angle", ""},
      {"lostopos-max-triangle-angle", "177", as_it_is, "remeshing.max_angle", ""},
      {"lostopos-large-triangle-angle-to-split", "160", as_it_is, "remeshing.split_angle", ""},
      {"lostopos-min-triangle-area-fraction", "0.02", as_it_is, "remeshing.min_area", ""},
      {"lostopos-t1-transition-enabled", "1", as_it_is, "topology.separate", ""},
      {"lostopos-t1-pull-apart-distance-fraction", "0.1", as_it_is, "topology.pull_apart", ""},
      {"lostopos-smooth-subdivision", "0", as_it_is, "remeshing.butterfly", ""},
      {"lostopos-allow-non-manifold", "1", converted, "topology.snap",
       "0: films do not join, which is what makes Plateau borders; those of the start surface stay"},
      {"lostopos-allow-topology-changes", "1", converted, "topology.enabled",
       "needs remeshing-iterations of 1 or more, as there"},
  };
}

std::string reference_key_rows(std::span<const ReferenceKey> keys) {
  std::string rows;
  for (const ReferenceKey& key : keys) {
    rows.append("| `").append(key.name).append("` | ").append(key.absent).append(" | ");
    rows.append(key.ours.empty() ? "none" : key.ours).append(" | ").append(key.meaning).append(" |\n");
  }
  return rows;
}

ReferenceValues::ReferenceValues(const std::string& file, std::span<const ReferenceKey> keys)
    : file_(file), keys_(keys) {
  for (const ReferenceKey& key : keys) absent_[std::string(key.name)] = {std::string(key.absent), file};
  base::require_text_file(file, "option file");
  std::ifstream stream(file);
  if (!stream) throw base::FileError(file + ": there is no such option file, or it cannot be read");
  std::string text;
  for (int number = 1; std::getline(stream, text); ++number) {
    std::istringstream words(text.substr(0, text.find('#')));
    std::string key, more;
    Line line{.value = {}, .where = file + ":" + std::to_string(number)};
    if (!(words >> key)) continue;
    if (!(words >> line.value) || words >> more)
      throw base::InputError(line.where + ": one value has to follow the key '" + key + "'");
    try {
      base::find_by_name(keys, key, "key");
    } catch (const base::InputError& error) {
      throw base::InputError(line.where + ": " + error.what());
    }
    given_[key] = std::move(line);
  }
}

const std::string& ReferenceValues::text(std::string_view key) const {
  const auto found = given_.find(key);
  return found != given_.end() ? found->second.value : absent_.find(key)->second.value;
}

const std::string& ReferenceValues::where(std::string_view key) const {
  const auto found = given_.find(key);
  return found != given_.end() ? found->second.where : absent_.find(key)->second.where;
}

OptionValue ReferenceValues::parsed(std::string_view key, const OptionValue& like) const {
  try {
    return base::parse_option(text(key), like);
  } catch (const base::InputError& error) {
    throw base::InputError(where(key) + ": " + std::string(key) + ": " + error.what());
  }
}

double ReferenceValues::number(std::string_view key) const {
  return std::get<double>(parsed(key, 0.0));
}
long ReferenceValues::whole(std::string_view key) const {
  return std::get<long>(parsed(key, 0L));
}
bool ReferenceValues::flag(std::string_view key) const {
  return std::get<bool>(parsed(key, false));
}

void ReferenceValues::set(std::string_view key, std::string_view ours, const OptionValue& value,
                          OptionSet& options) const {
  if (given(key))
    options.set(ours, value, where(key));
  else
    options.set_default(ours, value);
}

void ReferenceValues::set_as_it_is(std::string_view key, std::string_view ours, OptionSet& options) const {
  if (given(key))
    options.set_text(ours, text(key), where(key));
  else
    options.set_default(ours, parsed(key, options.value(ours)));
}

std::vector<std::string> set_tracker_options(const ReferenceValues& values, OptionSet& options) {
  for (const ReferenceKey& key : tracker_reference_keys(false))
    if (key.use == KeyUse::as_it_is) values.set_as_it_is(key.name, key.ours, options);
  const long iterations = values.whole("remeshing-iterations");
  if (iterations < 0)
    throw base::InputError(values.where("remeshing-iterations") + ": remeshing-iterations has to be >= 0");
  const bool changes = values.flag("lostopos-allow-topology-changes"),
             joins = values.flag("lostopos-allow-non-manifold");
  values.set("remeshing-iterations", "remeshing.enabled", iterations > 0, options);
  if (iterations > 0) values.set("remeshing-iterations", "remeshing.iterations", iterations, options);
  values.set("lostopos-perform-smoothing", "remeshing.smooth_below",
             values.flag("lostopos-perform-smoothing") ? 60.0 : 30.0, options);
  values.set("lostopos-allow-topology-changes", "topology.enabled", changes && iterations > 0, options);
  values.set("lostopos-allow-non-manifold", "topology.snap", joins, options);
  std::vector<std::string> notes;
  if (changes && iterations == 0 && values.given("lostopos-allow-topology-changes"))
    notes.push_back(values.where("lostopos-allow-topology-changes") +
                    ": the topology does not change, since remeshing-iterations is 0");
  return notes;
}

}  // namespace lostopos

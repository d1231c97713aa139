#include "FoamSim/effects/registry.h"

#include <gtest/gtest.h>

#include <set>

#include "Base/error.h"
#include "FoamSim/effects/damping.h"
#include "FoamSim/scenes/scene.h"
#include "FoamSim/scenes/shapes/solids.h"

namespace foamsim {
namespace {

base::OptionSet all_options() {
  return base::OptionSet(common_option_specs(*built_in_catalogue()));
}

std::vector<std::unique_ptr<Effect>> make(const std::vector<std::string>& names, const base::OptionSet& options) {
  return make_effects(built_in_effects(), names, {options, 0.1, built_in_catalogue()->sheet});
}

std::vector<std::string_view> names_of(const std::vector<std::unique_ptr<Effect>>& effects) {
  std::vector<std::string_view> names;
  names.reserve(effects.size());
  for (const auto& effect : effects) names.push_back(effect->name());
  return names;
}

TEST(EffectRegistry, MakesEveryEffectWithItsDefaults) {
  const base::OptionSet options = all_options();
  for (const EffectEntry& entry : built_in_effects()) {
    const std::vector<std::string> name{std::string(entry.name)};
    const auto effects = make(name, options);
    ASSERT_EQ(effects.size(), 1U);
    EXPECT_EQ(effects[0]->name(), entry.name);
    EXPECT_FALSE(entry.summary.empty());
  }
}

TEST(EffectRegistry, ConstructsOnlyWhatIsNamedInTheRegistrysOrder) {
  const base::OptionSet options = all_options();
  const std::vector<std::string> asked{"diffusion", "surface_tension"};
  EXPECT_EQ(names_of(make(asked, options)), (std::vector<std::string_view>{"surface_tension", "diffusion"}));
  EXPECT_TRUE(make({}, options).empty());
}

TEST(EffectRegistry, UnknownNameComesWithTheNearest) {
  const base::OptionSet options = all_options();
  const std::vector<std::string> asked{"difusion"};
  try {
    make(asked, options);
    FAIL() << "no error";
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'diffusion'"), std::string::npos) << error.what();
  }
}

TEST(EffectRegistry, OptionsSayWhichEffectReadsThemAndAreNamedOnce) {
  std::set<std::string> keys;
  for (const EffectEntry& entry : built_in_effects())
    for (const base::OptionSpec& spec : entry.options) {
      EXPECT_EQ(spec.owner.kind, "effect");
      EXPECT_EQ(spec.owner.name, entry.name);
      EXPECT_TRUE(keys.insert(spec.key).second) << spec.key;
      EXPECT_FALSE(spec.summary.empty()) << spec.key;
    }
  for (const char* key : {"sigma", "damping", "diffusion"}) EXPECT_EQ(keys.count(key), 1U) << key;
}

TEST(EffectRegistry, DefaultsAreTheReferences) {
  const base::OptionSet options = all_options();
  EXPECT_EQ(options.number("sigma"), 1);
  EXPECT_EQ(options.word("area"), "averaged");
  EXPECT_EQ(options.number("phi"), 0.5);
  EXPECT_EQ(options.number("damping"), 1);
  EXPECT_EQ(options.number("diffusion"), 10);
}

TEST(EffectRegistry, OptionsReachTheEffect) {
  base::OptionSet options = all_options();
  options.set("damping", 0.5, "test");
  lostopos::SurfaceMesh mesh = icosphere(0);
  SurfaceGeometry geometry;
  geometry.update(mesh);
  CirculationField circulation(mesh);
  const lostopos::Labels film{lostopos::Region(1), lostopos::air};
  circulation.set(lostopos::Vertex(0), film, 8);
  const std::vector<std::string> asked{"damping"};
  make(asked, options)[0]->update_circulation({mesh, geometry, 0, 2}, circulation);
  EXPECT_EQ(circulation.get(lostopos::Vertex(0), film), 2);
}

TEST(EffectRegistry, DampingMustBeAFactor) {
  base::OptionSet options = all_options();
  for (double bad : {0.0, -0.5, 1.5}) EXPECT_THROW(options.set("damping", bad, "test"), base::InputError) << bad;
  for (double bad : {-1.0}) EXPECT_THROW(options.set("sigma", bad, "test"), base::InputError) << bad;
  EXPECT_THROW(options.set("phi", 0.0, "test"), base::InputError);
  EXPECT_THROW(options.set("diffusion", -1.0, "test"), base::InputError);
}

}  // namespace
}  // namespace foamsim

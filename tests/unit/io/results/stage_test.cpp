#include "io/results/results.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <bit>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "core/error.hpp"
#include "io/disk/file.hpp"
#include "io/results/groups.hpp"
#include "support/sample_results.hpp"
#include "support/temporary_folder.hpp"

namespace {
using namespace arenite;
using arenite::io::read_file;
using arenite::io::read_stage;
using arenite::io::write_stage;
using arenite::test::TemporaryFolder;
using arenite::test::two_snapshots;

/// Not atomic, hence fast: hundreds of spoilt files.
void spill(const std::filesystem::path& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

std::string complaint_about(const std::filesystem::path& path) {
  try {
    read_stage(path);
  } catch (const InputError& error) { return error.what(); }
  return "";
}

/// Every bit of a result as text: NaN equals NaN and 0 differs from -0.
class Bits {
 public:
  void add(double v) { text_ += std::to_string(std::bit_cast<std::uint64_t>(v)) + ","; }
  void add(std::int64_t v) { text_ += std::to_string(v) + ","; }
  void add(Vec2 v) { add(v.x), add(v.y); }
  void add(const std::string& v) { text_ += std::to_string(v.size()) + ":" + v + ","; }
  template <class T> void add(const std::vector<T>& values) {
    text_ += "[";
    for (const auto& v : values) {
      if constexpr (std::is_floating_point_v<T> || std::is_same_v<T, Vec2>) add(v);
      else add(static_cast<std::int64_t>(v));
    }
    text_ += "]";
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

void add(Bits& bits, const Snapshot& f) {
  bits.add(f.time);
  bits.add(f.step);
  bits.add(f.label);
  for (const auto& m : f.packing.materials) {
    bits.add(m.name);
    for (const double v :
         {m.density, m.stiffness, m.thermoelastic_factor, m.youngs_modulus.value_or(-1), m.poisson.value_or(-1)})
      bits.add(v);
  }
  const auto& d = f.packing.domain;
  for (const auto& w : d.wall) {
    bits.add(std::int64_t{w.present});
    for (const double v : {w.position, w.velocity, w.force, w.shear_force}) bits.add(v);
  }
  bits.add(std::int64_t{d.periodic[0]} + 2 * std::int64_t{d.periodic[1]});
  bits.add(d.tilt);
  bits.add(d.thickness);
  const auto& g = f.packing.grains;
  bits.add(g.id);
  for (const auto* a : {&g.radius, &g.angle, &g.omega}) bits.add(*a);
  for (const auto* a : {&g.position, &g.velocity}) bits.add(*a);
  bits.add(g.material);
  bits.add(g.zone);
  const auto& c = f.packing.contacts;
  bits.add(c.i);
  bits.add(c.j);
  for (const auto* a : {&c.fn, &c.ft, &c.arm_i, &c.arm_j, &c.overlap, &c.sliding_velocity}) bits.add(*a);
  bits.add(c.normal);
  bits.add(c.glued);
  const auto& e = f.energies;
  for (const double v : {e.kinetic, e.elastic, e.adhesive, e.dissipated_normal, e.dissipated_friction,
                         e.dissipated_drag, e.dissipated_breakage, e.work_walls, e.work_gravity})
    bits.add(v);
  for (const double v : {f.equilibrium.unbalanced_ratio, f.equilibrium.kinetic_ratio, f.equilibrium.mobilisation,
                         f.equilibrium.wall_speed, f.equilibrium.falling, f.equilibrium.loose_kinetic})
    bits.add(v);
}

std::string bits_of(const StageResult& r) {
  Bits bits;
  for (const auto& s : {r.provenance.version, r.provenance.stage, r.provenance.input_hash, r.provenance.recipe,
                        r.provenance.kernel, r.name, r.outcome, to_json(r.texture)})
    bits.add(s);
  bits.add(static_cast<std::int64_t>(r.provenance.seed));
  for (const auto& [key, value] : r.provenance.options) {
    bits.add(key);
    bits.add(value);
  }
  bits.add(std::int64_t{r.converged});
  bits.add(r.continuation);
  for (const auto& f : r.snapshots) add(bits, f);
  for (const auto& column : r.history.columns) {
    bits.add(column.name);
    bits.add(column.unit);
    bits.add(column.values);
  }
  return bits.text();
}

double any_double() { return std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>()); }

std::string any_text() { return *rc::gen::container<std::string>(rc::gen::inRange<char>(1, 127)); }

Snapshot any_snapshot(std::size_t n, const Packing& sample) {
  Snapshot f;
  f.time = any_double();
  f.step = *rc::gen::arbitrary<std::int64_t>();
  f.label = any_text();
  f.packing = sample;
  for (auto& w : f.packing.domain.wall)
    w = {*rc::gen::arbitrary<bool>(), any_double(), any_double(), any_double(), any_double()};
  f.packing.domain.periodic[0] = *rc::gen::arbitrary<bool>();
  f.packing.domain.periodic[1] = *rc::gen::arbitrary<bool>();
  f.packing.domain.tilt = any_double();
  auto& g = f.packing.grains;
  for (auto* a : {&g.angle, &g.omega})
    for (double& v : *a) v = any_double();
  for (auto* a : {&g.position, &g.velocity})
    for (Vec2& v : *a) v = {any_double(), any_double()};
  if (n > 0 && *rc::gen::inRange(0, 3) == 0) {  // what seldom changes may change all the same
    g.radius[0] = any_double();
    g.zone[n - 1] = 9;
    g.id[0] = -5;
    f.packing.materials[0].density += 1;
  }
  const int contacts = n == 0 ? 0 : *rc::gen::inRange(0, 8);
  const auto grain = rc::gen::inRange<std::int32_t>(0, static_cast<std::int32_t>(std::max<std::size_t>(n, 1)));
  for (int c = 0; c < contacts; ++c) {
    const std::int32_t partner = *rc::gen::arbitrary<bool>() ? *grain : *rc::gen::inRange(-4, 0);
    f.packing.contacts.add(*grain, partner, {any_double(), any_double()}, any_double(), any_double(), any_double(),
                           any_double());
    f.packing.contacts.glued.back() = *rc::gen::arbitrary<std::uint8_t>();
  }
  f.energies.work_walls = any_double();
  f.equilibrium.mobilisation = any_double();
  f.equilibrium.falling = any_double();
  f.equilibrium.loose_kinetic = any_double();
  return f;
}

StageResult any_result() {
  StageResult r;
  r.provenance = {any_text(), any_text(), any_text(), any_text(), *rc::gen::arbitrary<std::uint64_t>(),
                  any_text(), {},         any_text()};
  for (const auto& key : *rc::gen::container<std::set<std::string>>(
           rc::gen::nonEmpty(rc::gen::container<std::string>(rc::gen::inRange('A', 'z')))))
    r.provenance.options.emplace_back(key, any_text());
  std::reverse(r.provenance.options.begin(), r.provenance.options.end());
  r.name = any_text();
  r.outcome = any_text();
  r.texture = {{"note", any_text()},
               {"list", {1, *rc::gen::arbitrary<std::uint64_t>(), any_double(), nullptr, true}},
               {"none", Numbers::tree()}};
  r.continuation = *rc::gen::arbitrary<std::vector<std::uint8_t>>();
  r.converged = *rc::gen::arbitrary<bool>();
  const auto n = *rc::gen::inRange<std::size_t>(0, 6);
  Packing sample;
  sample.materials = {{any_text(), any_double(), 1, 2}, {any_text(), 3, any_double(), 4}};
  if (*rc::gen::arbitrary<bool>()) sample.materials[1].youngs_modulus = 7e10, sample.materials[1].poisson = 0.22;
  sample.grains.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    sample.grains.radius[i] = any_double();
    sample.grains.material[i] = *rc::gen::inRange(0, 2);
  }
  const int snapshots = *rc::gen::inRange(0, 4);
  for (int f = 0; f < snapshots; ++f) r.snapshots.push_back(any_snapshot(n, sample));
  const int columns = *rc::gen::inRange(0, 4);
  const std::size_t samples = *rc::gen::inRange<std::size_t>(0, 1500);
  for (int c = 0; c < columns; ++c)
    r.history.columns.push_back(
        {"column " + std::to_string(9 - c), any_text(), std::vector<double>(samples, any_double())});
  return r;
}

TEST(StageFile, GivesBackEveryBitOfAnyResult) {
  const TemporaryFolder folder;
  ASSERT_TRUE(rc::check("round trip", [&folder] {
    const StageResult result = any_result();
    write_stage(folder / "r.h5", result);
    RC_ASSERT(bits_of(read_stage(folder / "r.h5")) == bits_of(result));
  }));
}

TEST(StageFile, SameResultGivesTheSameBytes) {
  const TemporaryFolder folder;
  const auto result = two_snapshots(2000);
  write_stage(folder / "a.h5", result);
  ::sleep(1);  // a clock of whole seconds, if one were stored, would tick
  write_stage(folder / "b.h5", result);
  EXPECT_EQ(read_file(folder / "a.h5"), read_file(folder / "b.h5"));
  auto other = result;
  other.snapshots[1].packing.grains.velocity[3].x += 1e-9;
  write_stage(folder / "c.h5", other);
  EXPECT_NE(read_file(folder / "a.h5"), read_file(folder / "c.h5"));
}

TEST(StageFile, RadiiAndMaterialsAreStoredOnceWhateverTheNumberOfSnapshots) {
  const TemporaryFolder folder;
  auto result = two_snapshots(2000);
  write_stage(folder / "two.h5", result);
  const auto two = std::filesystem::file_size(folder / "two.h5");
  for (auto& r : result.snapshots[1].packing.grains.radius)
    r *= 1 + 1e-9 * static_cast<double>(&r - &result.snapshots[1].packing.grains.radius[0]);
  write_stage(folder / "other.h5", result);
  EXPECT_GT(std::filesystem::file_size(folder / "other.h5"), two + 4000);
}

TEST(StageFile, CutAnywhereIsAnInputErrorThatSaysSo) {
  const TemporaryFolder folder;
  write_stage(folder / "whole.h5", two_snapshots());
  const std::string whole = read_file(folder / "whole.h5");
  std::vector<std::size_t> lengths{0, 1, 7, 8, 100, 511, 512, 513, 520, 600, whole.size() - 1};
  for (std::size_t length = 640; length < whole.size(); length += 97) lengths.push_back(length);
  for (const auto length : lengths) {
    spill(folder / "cut.h5", std::string_view(whole).substr(0, length));
    const auto said = complaint_about(folder / "cut.h5");
    EXPECT_NE(said.find(length == 0 ? "is empty" : "truncated"), std::string::npos) << length << ": " << said;
  }
}

TEST(StageFile, AnyChangedByteAfterTheSealIsNoticed) {
  const TemporaryFolder folder;
  write_stage(folder / "whole.h5", two_snapshots());
  const std::string whole = read_file(folder / "whole.h5");
  for (std::size_t at = 512; at < whole.size(); at += 331) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    spill(folder / "damaged.h5", damaged);
    EXPECT_NE(complaint_about(folder / "damaged.h5").find("changed or damaged"), std::string::npos) << at;
  }
}

TEST(StageFile, TextThatIsDamagedUnderARightSealIsTold) {
  const TemporaryFolder folder;
  const auto complaint = [&](const auto& spoil) {
    StageResult result = two_snapshots();
    spoil(result);
    write_stage(folder / "sealed.h5", result);
    return complaint_about(folder / "sealed.h5");
  };
  EXPECT_EQ(complaint([](StageResult& r) {
              r.texture = {{"grains", 5}, {"note", "a \\ and \xc3\xa4"}};
              r.outcome = "at rest \xc3\xa4 \"so\" \\";
            }),
            "");
  const std::string no_text = "at \xff rest";
  for (const auto& spoil : std::vector<std::function<void(StageResult&)>>{
           [&](StageResult& r) { r.outcome = no_text; }, [&](StageResult& r) { r.provenance.recipe = no_text; },
           [&](StageResult& r) { r.snapshots[0].label = no_text; },
           [&](StageResult& r) {
             r.texture = {{"note", no_text}};
           },
           [&](StageResult& r) { r.provenance.options[0].second = no_text; },
           [&](StageResult& r) { r.history.columns[0].unit = no_text; }})
    EXPECT_NE(complaint(spoil).find("damaged"), std::string::npos);
}

TEST(StageFile, ForeignAndNewerFilesAreTold) {
  const TemporaryFolder folder;
  spill(folder / "text.h5", "id,x,y\n1,2,3\n");
  EXPECT_NE(complaint_about(folder / "text.h5").find("is not a result of Arenite"), std::string::npos);
  spill(folder / "foreign.h5", std::string("\x89HDF\r\n\x1a\n", 8) + std::string(2000, '\0'));
  EXPECT_NE(complaint_about(folder / "foreign.h5").find("another program"), std::string::npos);
  write_stage(folder / "newer.h5", two_snapshots());
  std::string newer = read_file(folder / "newer.h5");
  newer.replace(newer.find("format 1"), 8, "format 2");
  spill(folder / "newer.h5", newer);
  EXPECT_NE(complaint_about(folder / "newer.h5").find("update Arenite"), std::string::npos);
  EXPECT_NE(complaint_about(folder / "none.h5").find("no such file"), std::string::npos);
}

}  // namespace

#include "grains/lammps/deck.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "grains/lammps/data.hpp"
#include "grains/lammps/laws.hpp"
#include "grains/lammps/servo.hpp"

namespace arenite::lammps {
namespace {

constexpr int look_interval = 200;  // steps between two looks whether the sample is at rest

template <int D> std::string head(const dem::SampleIn<D>& s, const Task& task) {
  std::string boundary;
  for (int axis = 0; axis < D; ++axis) boundary += s.domain.periodic[axis] ? " p" : " s";
  if (D == 2) boundary += " p";
  return fmt::format(
      "# {}\n"
      "# Written by arenite run --engine lammps; it begins with {}, or with -var from FILE at a restart file.\n"
      "units si\ndimension {}\nnewton off\natom_style sphere\ncomm_modify vel yes\nboundary{}\n"
      "variable from index data\n"
      "if \"${{from}} == data\" then \"read_data {}\" else \"read_restart ${{from}}\"\n"
      "print begun file {} screen no\n",
      task.title, names::data, D, boundary, names::data, names::begun);
}

template <int D> std::string law_lines(const dem::SampleIn<D>& s) {
  std::string text = "pair_style granular\n";
  const int materials = static_cast<int>(s.start.materials.size());
  for (int a = 0; a < materials; ++a)
    for (int b = a; b < materials; ++b) text += fmt::format("pair_coeff {} {} {}\n", a + 1, b + 1, pair_words(s, a, b));
  for (int a = 0; a < materials; ++a) text += fmt::format("group material_{0} type {0}\n", a + 1);
  return text +
         fmt::format("neighbor {:.9g} bin\nneigh_modify delay 0 every 1 check yes\ntimestep {:.17g}\n", s.skin, s.dt);
}

std::string plane_lines(const dem::SampleIn<2>& /*sample*/) { return "fix plane all enforce2d\n"; }
std::string plane_lines(const dem::SampleIn<3>& /*sample*/) { return ""; }
const char* shape_of(const dem::SampleIn<2>& /*sample*/) { return " disc"; }
const char* shape_of(const dem::SampleIn<3>& /*sample*/) { return ""; }

/// What moves the grains but for each other and the sides.
template <int D> std::string motion_lines(const dem::SampleIn<D>& s) {
  std::string text =
      s.integration.rotations ? fmt::format("fix move all nve/sphere{}\n", shape_of(s)) : "fix move all nve\n";
  if (const Vec3 g = in_space(s.gravity); norm(g) > 0)
    text += fmt::format("fix weight all gravity {:.17g} vector {:.17g} {:.17g} {:.17g}\n", norm(g), g.x, g.y, g.z);
  if (s.drag > 0) text += fmt::format("fix drag all langevin 0 0 {:.17g} 1\n", 1 / s.drag);
  return text;
}

/// Ends the run where the mean resultant force on a grain is a share of the mean force of a contact. As many contacts a
/// grain are taken as bear a sample without friction at most, for LAMMPS does not count those that touch.
template <int D> std::string rest_lines(const dem::SampleIn<D>& s, const Task& task) {
  if (!task.to_rest) return "";
  return fmt::format(
      "variable resultant atom sqrt(fx*fx+fy*fy+fz*fz)\n"
      "compute resultant all reduce sum v_resultant\n"
      "compute pair_force all pair/local force cutoff radius\n"
      "compute pair_force_sum all reduce sum c_pair_force\n"
      "variable busy equal \"({}*c_resultant >= {:g}*c_pair_force_sum){}\"\n"
      "fix rest all halt {} v_busy < 0.5 error continue message no\n",
      D, task.rest.unbalanced, loads_are_off(s, 10 * task.rest.unbalanced), look_interval);
}

/// Restart files in turn, with where the walls are then; a line of the log at each.
template <int D> std::string keeping_lines(const dem::SampleIn<D>& s, const Task& task) {
  std::string text = fmt::format("restart {0} restart1 restart2\n", task.restart_every);
  if (const std::string ways = pressed_walls(s, "$(v_way_", ":%.17g)"); !ways.empty())
    text += fmt::format("fix kept all print {} \"$(step){}\" append walls.txt screen no title \"\"\n",
                        task.restart_every, ways);
  return text + fmt::format("thermo_style custom step atoms\nthermo {}\nthermo_modify flush yes\n",
                            std::min<std::int64_t>(task.restart_every, 1000));
}

/// What lets a plane have its speed of then when forces are computed once more, which LAMMPS takes from the way since
/// it looked last: walls under a load stop for two steps, others are looked at where they were a step before.
template <int D> std::string last_look_lines(const dem::SampleIn<D>& s) {
  std::string stops, before, after;
  for (int side = 0; side < sides_in<D>; ++side) {
    const auto& drive = s.wall[side].drive;
    const char* name = any_side_names[side];
    if (s.domain.is_periodic(side) || !s.domain.wall[side].present) continue;
    if (is_pressed(s, side))
      stops += fmt::format("variable stop_{0} equal $(v_way_{0}:%.17g)\nvariable way_{0} equal v_stop_{0}\n", name);
    if (drive.kind != dem::DriveKind::velocity) continue;
    before += fmt::format("variable way_{} equal \"{:.17g}*(step - 1)*dt\"\n", name, drive.value);
    after += fmt::format("variable way_{} equal \"{:.17g}*step*dt\"\n", name, drive.value);
  }
  if (!stops.empty()) stops += "run 2\n";
  return before.empty() ? stops : stops + before + "run 0\n" + after;
}

template <int D> std::string dump_lines(const dem::SampleIn<D>& s) {
  std::string walls, ways;
  for (int side = 0; side < sides_in<D>; ++side) {
    if (s.domain.is_periodic(side) || !s.domain.wall[side].present) continue;
    ways +=
        fmt::format("print \"{0} $(v_way_{0}:%.17g)\" append {1}.part screen no\n", any_side_names[side], names::ended);
    for (std::size_t m = 0; m < s.start.materials.size(); ++m)
      for (int k = 2; k < 5; ++k) walls += fmt::format(" f_{}[{}]", wall_fix(side, static_cast<int>(m)), k);
  }
  return fmt::format(
      "compute ids all property/local patom1 patom2 cutoff radius\n"
      "compute forces all pair/local fx fy fz p1 p2 p3 cutoff radius\n"
      "dump state all custom 1 {1} id x y z vx vy vz omegax omegay omegaz fx fy fz{3}\n"
      "dump_modify state sort id first yes format float %.17g\n"
      "dump pairs all local 1 {2} c_ids[1] c_ids[2] c_forces[1] c_forces[2] c_forces[3] c_forces[4] c_forces[5] "
      "c_forces[6]\n"
      "dump_modify pairs first yes format float %.17g\n"
      "run 0\n"
      "print \"steps $(step)\" file {0}.part screen no\n{4}"
      "shell mv {0}.part {0}\n",
      names::ended, names::state, names::pairs, walls, ways);
}

/// awk's line of the walls at a step, as definitions.
template <int D> std::string walls_script(const dem::SampleIn<D>& s) {
  std::string prints;
  int column = 2;
  for (int side = 0; side < sides_in<D>; ++side)
    if (!s.domain.is_periodic(side) && is_pressed(s, side))
      prints += fmt::format(" print \"variable base_{} equal \" ${};", any_side_names[side], column++);
  if (prints.empty()) return "";
  return "#!/bin/sh\n# Where the walls were at a step, for the input that goes on from its restart file; where that is "
         "not known, a\n# line at which LAMMPS stops.\n"
         "awk -v step=\"$1\" '$1 == step {" +
         prints + " known = 1 } END { if (!known) print \"walls_are_not_known\" }' walls.txt > walls.now\n";
}

}  // namespace

std::string wall_fix(int side, int material) { return fmt::format("{}_{}", any_side_names[side], material + 1); }

template <int D> Deck deck_of(const dem::SampleIn<D>& s, const Task& task) {
  return {data_of(s, task.title),
          head(s, task) + law_lines(s) + motion_lines(s) + side_lines(s, task) + plane_lines(s) + rest_lines(s, task) +
              keeping_lines(s, task) + fmt::format("run {} upto\n", task.steps) + last_look_lines(s) + dump_lines(s),
          walls_script(s)};
}

template Deck deck_of(const dem::SampleIn<2>&, const Task&);
template Deck deck_of(const dem::SampleIn<3>&, const Task&);

}  // namespace arenite::lammps

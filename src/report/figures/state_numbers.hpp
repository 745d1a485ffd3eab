#pragma once
#include "grains/texture/force_scale.hpp"
#include "grains/texture/texture.hpp"
#include "model/film_result.hpp"
#include "model/result.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report::figures {

/// What figures of a state of a stage are described from, on the page and in print: the numbers of its texture with
/// their curves. Over those of the stage's last state lies what its results hold of it: what the texture lacks, and the
/// errors, which know how the state fluctuates in time.
Numbers state_numbers(const StageResult& stage, const Snapshot& state, const texture::Texture& texture);

/// The same of a state that nobody has measured yet, by the options of its stage. Without `curves` windows of growing
/// area are left out, too.
Numbers state_numbers(const StageResult& stage, const Snapshot& state, bool curves = true);

/// What forces of a state are told apart by, on the page and in print, from its numbers, where these are known.
texture::ForceScale force_scale(const Packing& packing, const Numbers& numbers);
texture::ForceScale force_scale(const FilmResult& film);
/// Of a stored state of spheres, by the mean of the forces that statistics consider.
texture::ForceScale force_scale(const SphereResult& stage, const SnapshotIn<3>& state);

}  // namespace arenite::report::figures

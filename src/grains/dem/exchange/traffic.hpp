#pragma once
#include "grains/dem/exchange/exchange.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Begins the account of a stage, and shortens the time step where the lightest grain that may come in asks for it.
/// Throws InputError where grains cannot be exchanged, or an area lies beyond the container.
void begin_exchange(Sample& sample, const Exchange& exchange);

/// Takes out the grains in the outlets and puts in those that are due `since` so many seconds. Grains for which no
/// place is found wait. Of a sample of one grain none leaves.
void exchange_grains(Sample& sample, const Exchange& exchange, double since, const ThreadPool& pool);

/// How many grains the inflows of a stage bring within a time, s, if all find room; by the mean mass of some of them
/// where a mass per time is asked for.
double grains_due(const Sample& sample, const Exchange& exchange, double time);

}  // namespace arenite::dem

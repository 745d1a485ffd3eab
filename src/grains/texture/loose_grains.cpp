#include "grains/texture/loose_grains.hpp"

namespace arenite::texture {

template <int D>
std::vector<std::uint8_t> loose_grains(const ContactsIn<D>& contacts, std::size_t n, int least,
                                       const std::function<bool(std::size_t)>& counts) {
  std::vector<std::vector<std::int32_t>> partners(n);
  std::vector<int> bearing(n, 0);
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (!counts(c)) continue;
    ++bearing[contacts.i[c]];
    if (contacts.is_wall(c)) continue;
    ++bearing[contacts.j[c]];
    partners[contacts.i[c]].push_back(contacts.j[c]);
    partners[contacts.j[c]].push_back(contacts.i[c]);
  }
  std::vector<std::uint8_t> loose(n, 0);
  std::vector<std::size_t> open;
  for (std::size_t g = 0; g < n; ++g)
    if (bearing[g] < least) open.push_back(g);
  while (!open.empty()) {
    const std::size_t g = open.back();
    open.pop_back();
    if (loose[g]) continue;
    loose[g] = 1;
    for (const std::int32_t p : partners[g])
      if (--bearing[p] < least && !loose[p]) open.push_back(p);
  }
  return loose;
}

template std::vector<std::uint8_t> loose_grains(const Contacts&, std::size_t, int,
                                                const std::function<bool(std::size_t)>&);
template std::vector<std::uint8_t> loose_grains(const ContactsIn<3>&, std::size_t, int,
                                                const std::function<bool(std::size_t)>&);

}  // namespace arenite::texture

// Objects that are not needed any more, kept for the memory they hold: containers of containers that are
// filled anew for each box or side.
#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

namespace cartesian
{

template <class T>
class Spares
{
public:
  // A new one, or one as it was left.
  T take()
  {
    if (spares_.empty())
    {
      return {};
    }
    T spare = std::move(spares_.back());
    spares_.pop_back();
    return spare;
  }

  // Empties the list.
  void putBack(std::vector<T>& used)
  {
    std::move(used.begin(), used.end(), std::back_inserter(spares_));
    used.clear();
  }

private:
  std::vector<T> spares_;
};

}

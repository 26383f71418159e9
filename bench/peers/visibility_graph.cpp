// The visibility graph of convex polygons under the sky by CGAL's triangular expansion from every corner, in exact
// arithmetic: the yardstick of `make bench-peers`.
//
//   visibility_graph SCENE.json > PAIRS
//
// Reads scenes with integer coordinates, polygons as lists of corners, as `viscomplex generate` writes them. Prints a line
// "0.1 2.3" for every two corners that see each other, unsorted, each pair once.
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangular_expansion_visibility_2.h>

#include <cctype>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <unordered_map>
#include <vector>

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_2;
using Segment = Kernel::Segment_2;
using Traits = CGAL::Arr_segment_traits_2<Kernel>;
using Arrangement = CGAL::Arrangement_2<Traits>;
using Visibility = CGAL::Triangular_expansion_visibility_2<Arrangement, CGAL::Tag_true>;

namespace {

struct Corner {
  int polygon, number;
  Point at;
};

// The lists of pairs of integers after "polygons".
std::vector<std::vector<Point>> read_polygons(const std::string& text) {
  std::vector<std::vector<Point>> polygons;
  std::vector<long long> numbers;
  int depth = 0;
  for (size_t i = text.find('[', text.find("\"polygons\"")); i < text.size(); ++i) {
    const char c = text[i];
    if (c == '[') {
      if (++depth == 2) numbers.clear();
    } else if (c == ']') {
      if (depth-- == 2) {
        polygons.emplace_back();
        for (size_t k = 0; k + 1 < numbers.size(); k += 2) polygons.back().emplace_back(numbers[k], numbers[k + 1]);
      }
      if (depth == 0) break;
    } else if (c == '-' || std::isdigit(static_cast<unsigned char>(c))) {
      size_t length = 0;
      numbers.push_back(std::stoll(text.substr(i, 24), &length));
      i += length - 1;
    }
  }
  return polygons;
}

struct Place {
  double x, y;
  bool operator==(const Place& other) const { return x == other.x && y == other.y; }
};

struct HashPlace {
  size_t operator()(const Place& p) const { return std::hash<double>()(p.x) * 1000003 ^ std::hash<double>()(p.y); }
};

Place place_of(const Point& p) { return {CGAL::to_double(p.x()), CGAL::to_double(p.y())}; }

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "visibility_graph SCENE.json\n";
    return 1;
  }
  std::ifstream file(argv[1]);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const auto polygons = read_polygons(text);

  std::vector<Corner> corners;
  std::vector<Segment> segments;
  std::unordered_map<Place, int, HashPlace> by_place;
  double low_x = 0, low_y = 0, high_x = 0, high_y = 0;
  for (size_t p = 0; p < polygons.size(); ++p)
    for (size_t k = 0; k < polygons[p].size(); ++k) {
      const Point& at = polygons[p][k];
      by_place[place_of(at)] = static_cast<int>(corners.size());
      corners.push_back({static_cast<int>(p), static_cast<int>(k), at});
      segments.emplace_back(at, polygons[p][(k + 1) % polygons[p].size()]);
      const Place q = place_of(at);
      low_x = std::min(low_x, q.x), low_y = std::min(low_y, q.y);
      high_x = std::max(high_x, q.x), high_y = std::max(high_y, q.y);
    }
  const double margin = 1 + (high_x - low_x) + (high_y - low_y);
  const std::vector<Point> box = {{low_x - margin, low_y - margin},
                                  {high_x + margin, low_y - margin},
                                  {high_x + margin, high_y + margin},
                                  {low_x - margin, high_y + margin}};
  for (size_t k = 0; k < 4; ++k) segments.emplace_back(box[k], box[(k + 1) % 4]);

  Arrangement arrangement;
  CGAL::insert_non_intersecting_curves(arrangement, segments.begin(), segments.end());
  // Free space is the face inside the box that has the polygons as holes.
  Arrangement::Face_const_handle free_space;
  for (auto f = arrangement.faces_begin(); f != arrangement.faces_end(); ++f)
    if (!f->is_unbounded() && (polygons.empty() || f->holes_begin() != f->holes_end())) free_space = f;

  Visibility visibility(arrangement);
  std::string out;
  for (auto hole = free_space->holes_begin(); hole != free_space->holes_end(); ++hole) {
    auto e = *hole;
    const auto first = e;
    do {
      const Point& eye = e->target()->point();
      const int from = by_place.at(place_of(eye));
      Arrangement region;
      visibility.compute_visibility(eye, e, region);
      for (auto v = region.vertices_begin(); v != region.vertices_end(); ++v) {
        const auto found = by_place.find(place_of(v->point()));
        if (found == by_place.end() || found->second <= from || corners[found->second].at != v->point()) continue;
        const Corner &a = corners[from], &b = corners[found->second];
        out += std::to_string(a.polygon) + '.' + std::to_string(a.number) + ' ' + std::to_string(b.polygon) + '.' +
               std::to_string(b.number) + '\n';
      }
      ++e;
    } while (e != first);
  }
  std::fwrite(out.data(), 1, out.size(), stdout);
  return 0;
}

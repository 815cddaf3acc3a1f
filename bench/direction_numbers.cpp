// Searches for direction numbers of Sobol's sequence for the joint dimensions; those of src/sampling/sobol_table.cpp
// came from it (seed 31). Some projections of the points matter more to a picture than others: what a pixel sees
// changes at edges that run through its area and the lens, its area and a light, or its area and time. Dimensions 0 and
// 1, the pixel, are fixed: together they are a (0,2)-sequence. For the others, simulated annealing chooses polynomials
// and initial numbers. It lowers a weighted sum, over all sizes 2^m, of the surplus points in elementary intervals of
// the pairs, the triples and the three projections to four dimensions that matter.
//
//   direction_numbers [SEED [STEPS]]    prints the numbers, and t for each projection and each number of points
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

namespace {

constexpr int dimension_count = 7, first_free = 2, time_dimension = 6;
constexpr int largest_m = 11;
constexpr int polynomial_count = 11, largest_degree = 5;

struct Polynomial {
  int degree;
  std::uint32_t coefficients;  // those between the first and the last
};
constexpr std::array<Polynomial, polynomial_count> polynomials{
    {{2, 1}, {3, 1}, {3, 2}, {4, 1}, {4, 4}, {5, 2}, {5, 4}, {5, 7}, {5, 11}, {5, 13}, {5, 14}}};

// Bit c of row r: whether bit c of the index flips bit r of the coordinate, the highest being bit 0.
using Matrix = std::array<std::uint32_t, largest_m>;

Matrix matrix_of(const std::array<std::uint32_t, largest_m>& direction_numbers) {
  Matrix matrix{};
  for (int row = 0; row < largest_m; row++) {
    for (int column = 0; column < largest_m; column++) {
      matrix[row] |= (direction_numbers[column] >> (31 - row) & 1) << column;
    }
  }
  return matrix;
}

struct Dimension {
  int polynomial = 0;
  std::array<std::uint32_t, largest_degree> initial{};

  Matrix matrix() const {
    const Polynomial& p = polynomials[polynomial];
    std::array<std::uint32_t, largest_m> v{};
    for (int i = 0; i < largest_m; i++) {
      if (i < p.degree) {
        v[i] = initial[i] << (31 - i);
        continue;
      }
      v[i] = v[i - p.degree] ^ (v[i - p.degree] >> p.degree);
      for (int k = 1; k < p.degree; k++) {
        if (p.coefficients >> (p.degree - 1 - k) & 1) v[i] ^= v[i - k];
      }
    }
    return matrix_of(v);
  }
};

using Matrices = std::array<Matrix, dimension_count>;

// How many of the rows are linearly dependent on the others.
int dependent_rows(const std::vector<std::uint32_t>& rows) {
  std::vector<std::uint32_t> basis;
  for (std::uint32_t row : rows) {
    for (const std::uint32_t b : basis) row = std::min(row, row ^ b);
    if (row != 0) basis.push_back(row);
  }
  return static_cast<int>(rows.size() - basis.size());
}

// Calls `visit(dependent)` for all shapes of elementary intervals of volume 2^-bits in these dimensions, with at least
// `fewest` bits in each dimension, for 2^m points. Such an interval has 2^dependent times too many points, or none.
template <class Visit>
void for_shapes(const Matrices& matrices, const std::vector<int>& dimensions, int m, int bits, int fewest,
                const Visit& visit) {
  std::vector<std::uint32_t> rows;
  const auto choose = [&](const auto& self, std::size_t i, int left) -> void {
    const int others = static_cast<int>(dimensions.size() - i - 1) * fewest;
    for (int n = i + 1 == dimensions.size() ? left : fewest; n <= left - others; n++) {
      const std::size_t before = rows.size();
      for (int row = 0; row < n; row++) rows.push_back(matrices[dimensions[i]][row] & ((1u << m) - 1));
      if (i + 1 == dimensions.size()) {
        visit(dependent_rows(rows));
      } else {
        self(self, i + 1, left - n);
      }
      rows.resize(before);
    }
  };
  choose(choose, 0, bits);
}

struct Projection {
  std::vector<int> dimensions;
  double weight;

  bool has(int dimension) const {
    return std::find(dimensions.begin(), dimensions.end(), dimension) != dimensions.end();
  }

  double energy(const Matrices& matrices) const {
    double sum = 0;
    for (int m = 2; m <= largest_m; m++) {
      // Sums grow with the number of shapes, approximately like this.
      constexpr double typical[] = {1, 1, 90, 290, 490, 880, 1450, 2350, 3450, 5000, 6500, 9000};
      double too_many = 0;
      for (int bits = std::max(static_cast<int>(dimensions.size()), m - 2); bits <= m; bits++) {
        const double factor = std::pow(3, m - bits);
        for_shapes(matrices, dimensions, m, bits, 1,
                   [&](int dependent) { too_many += factor * ((1 << dependent) - 1); });
      }
      sum += too_many * weight / typical[m];
    }
    return sum;
  }

  int t(const Matrices& matrices, int m) const {
    for (int bits = m; bits > 0; bits--) {
      int dependent = 0;
      for_shapes(matrices, dimensions, m, bits, 0, [&](int d) { dependent += d; });
      if (dependent == 0) return m - bits;
    }
    return m;
  }
};

std::vector<Projection> projections_that_matter() {
  std::vector<Projection> result;
  for (int a = 0; a < dimension_count; a++) {
    for (int b = a + 1; b < dimension_count; b++) {
      const bool is_place = b == a + 1 && a % 2 == 0;  // in the pixel, on the lens, on the light
      result.push_back({{a, b}, (is_place ? 100.0 : 10.0) * (b == time_dimension ? 2 : 1)});
      for (int c = b + 1; c < dimension_count; c++) result.push_back({{a, b, c}, c == time_dimension ? 8.0 : 4.0});
    }
  }
  for (const auto& four : {std::vector{0, 1, 2, 3}, {0, 1, 4, 5}, {2, 3, 4, 5}}) result.push_back({four, 8});
  return result;
}

class Search {
 public:
  Search(std::uint32_t seed, int steps) : random_(seed), projections_(projections_that_matter()) {
    matrices_[0] = matrix_of([] {
      std::array<std::uint32_t, largest_m> v{};
      for (int i = 0; i < largest_m; i++) v[i] = 1u << (31 - i);
      return v;
    }());
    for (int row = 0; row < largest_m; row++) {  // Pascal's triangle modulo 2
      for (int column = row; column < largest_m; column++) {
        if ((row & column) == row) matrices_[1][row] |= 1u << column;
      }
    }
    std::vector<int> order(polynomial_count);
    for (int i = 0; i < polynomial_count; i++) order[i] = i;
    std::shuffle(order.begin(), order.end(), random_);
    for (int d = first_free; d < dimension_count; d++) {
      dimensions_[d].polynomial = order[d - first_free];
      draw_initial(dimensions_[d]);
      matrices_[d] = dimensions_[d].matrix();
    }
    for (const Projection& projection : projections_) {
      energies_.push_back(projection.energy(matrices_));
      energy_ += energies_.back();
    }
    double best = energy_;
    auto best_dimensions = dimensions_;
    for (int i = 0; i < steps; i++) {
      const double left = 1 - static_cast<double>(i) / steps;
      step(0.03 * energy_ * left * left + 1e-9);
      if (energy_ >= best - 1e-9) continue;
      best = energy_;
      best_dimensions = dimensions_;
    }
    dimensions_ = best_dimensions;
    for (int d = first_free; d < dimension_count; d++) matrices_[d] = dimensions_[d].matrix();
    energy_ = best;
  }

  void print() const {
    std::printf("energy %.4f\ndegree, coefficients, initial numbers of dimensions 2 to 6:\n", energy_);
    for (int d = first_free; d < dimension_count; d++) {
      const Polynomial& p = polynomials[dimensions_[d].polynomial];
      std::printf("    {%d, %u, {", p.degree, p.coefficients);
      for (int i = 0; i < p.degree; i++) std::printf("%s%u", i == 0 ? "" : ", ", dimensions_[d].initial[i]);
      std::printf("}},\n");
    }
    std::printf("t of 4, 8, ... %d points:\n", 1 << largest_m);
    for (const Projection& projection : projections_) {
      for (const int d : projection.dimensions) std::printf("%d", d);
      std::printf(":");
      for (int m = 2; m <= largest_m; m++) std::printf(" %d", projection.t(matrices_, m));
      std::printf("\n");
    }
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  void draw_initial(Dimension& dimension) {
    for (int i = 0; i < largest_degree; i++) dimension.initial[i] = (random_() & ((2u << i) - 1)) | 1;
  }

  bool is_used(int polynomial, int but) const {
    for (int d = first_free; d < dimension_count; d++) {
      if (d != but && dimensions_[d].polynomial == polynomial) return true;
    }
    return false;
  }

  // Changes something at random; keeps it if it is better, or with a probability that falls with how much worse it is.
  void step(double temperature) {
    const auto dimensions = dimensions_;
    const Matrices matrices = matrices_;
    const int d = first_free + below(dimension_count - first_free);
    int other = d;
    switch (below(4)) {
      case 0:
        other = first_free + below(dimension_count - first_free);
        if (other == d) return;
        std::swap(dimensions_[d], dimensions_[other]);
        break;
      case 1: {
        const int polynomial = below(polynomial_count);
        if (is_used(polynomial, d)) return;
        dimensions_[d].polynomial = polynomial;
        draw_initial(dimensions_[d]);
        break;
      }
      default: {
        const int i = 1 + below(polynomials[dimensions_[d].polynomial].degree - 1);
        dimensions_[d].initial[i] ^= 2u << below(i);
      }
    }
    matrices_[d] = dimensions_[d].matrix();
    matrices_[other] = dimensions_[other].matrix();
    double energy = energy_;
    std::vector<double> energies = energies_;
    for (std::size_t i = 0; i < projections_.size(); i++) {
      if (!projections_[i].has(d) && !projections_[i].has(other)) continue;
      energy -= energies[i];
      energies[i] = projections_[i].energy(matrices_);
      energy += energies[i];
    }
    if (energy <= energy_ || std::exp((energy_ - energy) / temperature) * 4294967296.0 > random_()) {
      energy_ = energy;
      energies_ = energies;
    } else {
      dimensions_ = dimensions;
      matrices_ = matrices;
    }
  }

  std::mt19937 random_;
  std::vector<Projection> projections_;
  std::array<Dimension, dimension_count> dimensions_{};
  Matrices matrices_{};
  std::vector<double> energies_;
  double energy_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  const int seed = argc > 1 ? std::atoi(argv[1]) : 31;
  const int steps = argc > 2 ? std::atoi(argv[2]) : 12000;
  Search(static_cast<std::uint32_t>(seed), steps).print();
}

// Products of many rotations about lines.
#include <cmath>
#include <glm/glm.hpp>
#include <memory>

#include "lab/accuracy/operations/elementwise_variant.hpp"
#include "lab/accuracy/operations/operations.hpp"
#include "morphcl/transform.hpp"

namespace morphcl::accuracy {

namespace {

// Constants of a batch: how many factors a product has, and how far away the lines are. The factors of element i follow
// from its seed, plane 0: the same for all variants and the reference, which take the product's fp64 matrices as exact.
using Factors = std::vector<glm::dmat4>;

Factors factors_of(double seed, double count, double distance) {
  Random random(static_cast<std::uint64_t>(seed));
  Factors factors;
  for (int f = 0; f < static_cast<int>(count); ++f) {
    const auto point = [&](double size) {
      glm::dvec3 drawn;  // z first: the numbers of docs/accuracy.md
      for (int axis = 2; axis >= 0; --axis) drawn[axis] = random.uniform(-size, size);
      return drawn;
    };
    const glm::dvec3 from = point(distance), to = from + point(1);
    factors.push_back(CompositeTransform().rotate_about_axis(from, to, random.uniform(-180, 180)).matrix());
  }
  return factors;
}

std::vector<Factors> all_factors(const Batch& batch) {
  std::vector<Factors> all;
  for (std::size_t i = 0; i < batch.size(); ++i)
    all.push_back(factors_of(batch.truth.plane(0)[i], batch.constants[0], batch.constants[1]));
  return all;
}

void store(const glm::dmat4& m, std::size_t i, Planes<double>& results) {
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      results.plane(static_cast<std::size_t>(4 * row + column))[i] = m[column][row];
}

// The product of factors that were converted to Matrix, computed in Product.
template <class Matrix, class Product>
Variant<double> multiplied(const char* name) {
  return {.name = name, .prepare = [](const Batch& batch) -> Variant<double>::Run {
            auto all = std::make_shared<std::vector<std::vector<Product>>>();
            for (const Factors& factors : all_factors(batch)) {
              all->emplace_back();
              for (const glm::dmat4& factor : factors) all->back().push_back(Product(Matrix(factor)));
            }
            return [all](Planes<double>& results) {
              for (std::size_t i = 0; i < all->size(); ++i) {
                Product product(1);
                for (const Product& factor : (*all)[i]) product = factor * product;
                store(glm::dmat4(product), i, results);
              }
            };
          }};
}

Variant<double> composite() {
  return {.name = "CompositeTransform",
          .prepare = [](const Batch& batch) -> Variant<double>::Run {
            auto all = std::make_shared<std::vector<CompositeTransform>>();
            for (const Factors& factors : all_factors(batch)) {
              all->emplace_back();
              for (const glm::dmat4& factor : factors) all->back().matrix_step(factor);
            }
            return [all](Planes<double>& results) {
              for (std::size_t i = 0; i < all->size(); ++i) store((*all)[i].matrix(), i, results);
            };
          },
          .ships = true};
}

InputFamily compose_family(const char* name, const char* text, double factors, double distance) {
  return {name, text, [=](Random& random, std::size_t count) {
            return drawn(random, 1, count, {factors, distance},
                         [](Random& r, double* in) { in[0] = static_cast<double>(r.bits() >> 12); });
          }};
}

}  // namespace

Operation compose() {
  PlanarOperation<double> op;
  op.about = {.name = "compose",
              .title = "the product of 64 rotations about lines; times are for one factor",
              .results = "matrix entries",
              .format = binary32,
              .plotted = Measure::max_scaled,
              .target = 0.5,
              .reason = "below the one rounding to binary32 that follows"};
  op.results = 12;
  op.families = {
      compose_family("benign", "lines within 1 of the origin", 64, 1),
      compose_family("wide", "lines within 1000 of the origin", 64, 1000),
      compose_family("adversarial", "lines within 10^8 of the origin", 64, 1e8),
  };
  op.reference = Reference([](const Inputs& in, std::size_t i, auto* results) {
    using Number = NumberOf<decltype(results)>;
    const Factors factors = factors_of(in(0, i), in.constant(0), in.constant(1));
    std::array<std::array<Number, 4>, 3> product{};
    for (std::size_t row = 0; row < 3; ++row) product[row][row] = 1;
    for (const glm::dmat4& factor : factors) {
      std::array<std::array<Number, 4>, 3> next;
      for (int row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 4; ++column) {
          Number sum = column == 3 ? factor[3][row] : 0.0;
          for (int k = 0; k < 3; ++k) sum += product[static_cast<std::size_t>(k)][column] * factor[k][row];
          next[static_cast<std::size_t>(row)][column] = sum;
        }
      product = next;
    }
    // Entries of the rotation are at most 1, translations as large as the lines are far.
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t column = 0; column < 4; ++column)
        results[4 * row + column] = {product[row][column], column == 3 ? Number(in.constant(1)) : Number(1)};
  });
  op.variants = {
      multiplied<glm::mat4, glm::mat4>("fp32 factors and products"),
      multiplied<glm::mat4, glm::dmat4>("fp32 factors, fp64 products"),
      multiplied<glm::dmat4, glm::dmat4>("fp64"),
      composite(),
  };
  op.compared = 128;
  op.batch = 64;
  op.steps_per_element = 64;
  return operation_of(std::move(op));
}

}  // namespace morphcl::accuracy

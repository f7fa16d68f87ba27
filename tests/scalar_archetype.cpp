/// The least that a formula may ask of its scalar: made from int only, `double` and `<` deleted. What compiles here is
/// a formula; what runs here has no branch on a value.

#include <gtest/gtest.h>

#include <concepts>
#include <experimental/simd>
#include <goishi/mass/inertia.hpp>
#include <goishi/mass/tensor.hpp>
#include <goishi/scalar.hpp>
#include <goishi/shape/stone.hpp>

namespace {

/// Nothing but + − × ÷ and whole numbers, and elementary functions if asked for.
template <bool elementary>
class ArchetypeScalar {
 public:
  explicit ArchetypeScalar(int n) : value_(n) {}
  explicit ArchetypeScalar(std::same_as<double> auto) = delete;
  explicit ArchetypeScalar(std::same_as<float> auto) = delete;
  bool operator<(const ArchetypeScalar&) const = delete;
  bool operator==(const ArchetypeScalar&) const = delete;
  [[nodiscard]] double value() const { return value_; }

  using Self = ArchetypeScalar;
  friend Self operator+(const Self& x, const Self& y) { return of(x.value_ + y.value_); }
  friend Self operator-(const Self& x, const Self& y) { return of(x.value_ - y.value_); }
  friend Self operator*(const Self& x, const Self& y) { return of(x.value_ * y.value_); }
  friend Self operator/(const Self& x, const Self& y) { return of(x.value_ / y.value_); }
  friend Self operator-(const Self& x) { return of(-x.value_); }
  friend Self sqrt(const Self& x) requires elementary { return of(std::sqrt(x.value_)); }
  friend Self sin(const Self& x) requires elementary { return of(std::sin(x.value_)); }
  friend Self cos(const Self& x) requires elementary { return of(std::cos(x.value_)); }
  friend Self atan2(const Self& y, const Self& x) requires elementary { return of(std::atan2(y.value_, x.value_)); }

 private:
  static Self of(double value) {
    Self result(0);
    result.value_ = value;
    return result;
  }
  double value_;
};

using Archetype = ArchetypeScalar<false>;
using ElementaryArchetype = ArchetypeScalar<true>;

static_assert(goishi::Field<Archetype> && !goishi::Elementary<Archetype> && !goishi::Ordered<Archetype>);
static_assert(goishi::Elementary<ElementaryArchetype> && !goishi::Ordered<ElementaryArchetype>);
static_assert(goishi::Ordered<float> && goishi::Ordered<double> && goishi::Ordered<long double>);
static_assert(!goishi::Field<int*> && !goishi::Field<std::string>);

// A batch compares to a mask, so it is a scalar of formulas, not of algorithms.
using Batch = std::experimental::native_simd<double>;
static_assert(goishi::Elementary<Batch> && !goishi::Ordered<Batch>);

// The wider type is wider, and stays for others.
static_assert(std::same_as<goishi::scalar::wider_t<float>, double>);
static_assert(std::same_as<goishi::scalar::wider_t<double>, long double>);
static_assert(std::same_as<goishi::scalar::wider_t<Archetype>, Archetype>);

namespace formula = goishi::formula;

TEST(Archetype, RunsTheRationalFormulas) {
  const Archetype w(22), h(9);
  EXPECT_EQ(formula::sphere_radius(w, h).value(), (22.0 * 22.0 + 81.0) / 36.0);
  EXPECT_EQ(formula::sphere_offset(w, h).value(), 13.0 * 31.0 / 36.0);
  EXPECT_EQ(formula::sharp_stone(w, h).joint_radius.value(), 11.0);
  EXPECT_GT(formula::lens_moments_per_mass(w, h).axial.value(), 0.0);
  EXPECT_GT(formula::arc_integrals(w, h, h).c5.value(), 0.0);
}

TEST(Archetype, RunsTheElementaryFormulas) {
  const ElementaryArchetype w(22), h(9), b(1);
  const auto offset = formula::measured_sphere_offset(w, h, b);
  const auto stone = formula::bevelled_stone(formula::generating_width(h, offset), h, b, offset);
  const auto terms = formula::bevel_terms(stone, goishi::scalar::atan2(stone.joint_sine, stone.joint_cosine));
  EXPECT_DOUBLE_EQ(goishi::outer_width(stone).value(), 22.0);
  EXPECT_GT(formula::bevelled_volume(stone, terms).value(), 0.0);
  EXPECT_GT(formula::bevelled_surface_area(stone, terms).value(), 0.0);
  EXPECT_GT(formula::bevelled_moments(stone, terms).axial.value(), 0.0);
  EXPECT_GT(formula::lens_volume(w, h).value(), 0.0);
  EXPECT_GT(formula::lens_surface_area(w, h).value(), 0.0);
  EXPECT_GT(formula::lens_moments(w, h).transverse.value(), 0.0);
}

TEST(Archetype, RunsTheTensorFormulas) {
  using goishi::Mat3;
  using goishi::Vec3;
  // Eigen itself sets matrices to zero and adds; the batch is the archetype that it accepts.
  Vec3<Batch> shift;
  shift << Batch(1.0), Batch(2.0), Batch(3.0);
  const Mat3<Batch> tensor = formula::shifted_tensor(
      formula::principal_tensor(goishi::Moments<Batch>{.axial = Batch(2.0), .transverse = Batch(1.5)}), Batch(3.0),
      shift);
  EXPECT_EQ(static_cast<double>(tensor(0, 0)[0]), 1.5 + 3.0 * 13.0);
  EXPECT_EQ(static_cast<double>(tensor(0, 1)[0]), -6.0);
}

TEST(Scalar, BatchesGiveWhatTheirLanesGive) {
  const Batch w([](auto lane) { return 1.0 + 0.1 * static_cast<double>(lane); });
  const Batch h = w * Batch(0.4);
  const Batch b = h * Batch(0.1);
  const auto batch = formula::bevelled_stone(w, h, b, formula::sphere_offset(w, h));
  const auto terms = formula::bevel_terms(batch, goishi::scalar::atan2(batch.joint_sine, batch.joint_cosine));
  const Batch volume = formula::bevelled_volume(batch, terms);
  for (std::size_t lane = 0; lane < Batch::size(); ++lane) {
    const auto one =
        formula::bevelled_stone<double>(w[lane], h[lane], b[lane], formula::sphere_offset<double>(w[lane], h[lane]));
    const auto one_terms = formula::bevel_terms(one, std::atan2(one.joint_sine, one.joint_cosine));
    EXPECT_DOUBLE_EQ(volume[lane], formula::bevelled_volume(one, one_terms));
  }
}

TEST(Scalar, IsFiniteKnowsNanAndInfinity) {
  using goishi::scalar::is_finite;
  EXPECT_TRUE(is_finite(0.0));
  EXPECT_TRUE(is_finite(std::numeric_limits<double>::max()));
  EXPECT_TRUE(is_finite(std::numeric_limits<double>::denorm_min()));
  EXPECT_FALSE(is_finite(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(is_finite(-std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(is_finite(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace

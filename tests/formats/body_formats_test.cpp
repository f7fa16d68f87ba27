/// Files of bodies, read back by libsdformat, the reader of Gazebo: SDF, and URDF through its own conversion.

#include "formats/body_formats.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <goishi/shape/catalogue.hpp>
#include <optional>
#include <sdf/sdf.hh>
#include <string>

namespace goishi::cli {
namespace {

struct ReadBody {
  double mass;
  Mat3<double> tensor;
  Vec3<double> center;
  std::string mesh;
};

/// The only link of the only model; nothing when libsdformat finds an error.
std::optional<ReadBody> read_back(const std::string& text) {
  sdf::Root root;
  if (!root.LoadSdfString(text).empty() || root.Model() == nullptr || root.Model()->LinkCount() != 1) {
    return std::nullopt;
  }
  const sdf::Link& link = *root.Model()->LinkByIndex(0);
  if (link.CollisionCount() != 1 || link.CollisionByIndex(0)->Geom()->MeshShape() == nullptr) {
    return std::nullopt;
  }
  const auto& inertia = link.Inertial();
  const auto tensor = inertia.Moi();
  ReadBody body{.mass = inertia.MassMatrix().Mass(),
                .tensor = {},
                .center = {inertia.Pose().Pos().X(), inertia.Pose().Pos().Y(), inertia.Pose().Pos().Z()},
                .mesh = link.CollisionByIndex(0)->Geom()->MeshShape()->Uri()};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      body.tensor(i, j) = tensor(static_cast<unsigned>(i), static_cast<unsigned>(j));
    }
  }
  return body;
}

BodyFile some_body() {
  const Number bevel = Number(1) / 1000;
  const Stone<Number> stone = make_stone<Number>(catalogue_stone(33, StoneColor::white), bevel);
  return {.comment = "A stone.",
          .mesh = "stone.obj",
          .properties = mass_properties(stone, Density{Number(2800)}),
          .color = {1, 1, 1}};
}

double as_read(const Number& value) {
  return std::stod(seventeen_digits(value));
}

/// The greatest relative error of mass and moments.
double error_of(const ReadBody& read, const BodyFile& body) {
  const double axial = as_read(body.properties.moments.axial);
  const double transverse = as_read(body.properties.moments.transverse);
  const Vec3<double> moments(transverse, transverse, axial);
  const Mat3<double> off = read.tensor - Mat3<double>(moments.asDiagonal());
  return std::max(std::abs(read.mass / as_read(body.properties.mass) - 1), off.cwiseAbs().maxCoeff() / transverse);
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(BodyFormats, SdfGivesMassAndMomentsToTheLastBit) {
  const std::optional<ReadBody> read = read_back(as_sdf(some_body()));
  ASSERT_TRUE(read);
  EXPECT_EQ(error_of(*read, some_body()), 0);
  EXPECT_EQ(read->center, Vec3<double>::Zero());
  EXPECT_EQ(read->mesh, "stone.obj");
}

TEST(BodyFormats, UrdfIsConverted) {
  const std::optional<ReadBody> read = read_back(as_urdf(some_body()));
  ASSERT_TRUE(read);
  EXPECT_LT(error_of(*read, some_body()), 1e-15);  // the conversion prints 16 digits
  EXPECT_EQ(read->center, Vec3<double>::Zero());
  EXPECT_EQ(read->mesh, "stone.obj");
}

TEST(BodyFormats, BadBodiesAreNoticed) {
  const BodyFile body = some_body();
  const std::string mass = seventeen_digits(body.properties.mass);
  const std::string axial = seventeen_digits(body.properties.moments.axial);
  const std::string transverse = seventeen_digits(body.properties.moments.transverse);
  const std::string sdf = as_sdf(body), urdf = as_urdf(body);
  EXPECT_FALSE(read_back(changed(sdf, mass, "-" + mass)));
  EXPECT_FALSE(read_back(changed(sdf, "<ixx>" + transverse + "</ixx>", "")));
  EXPECT_FALSE(read_back(changed(sdf, axial, "1")));
  EXPECT_FALSE(read_back(changed(sdf, "<mesh>", "<mesh><mesh>")));
  EXPECT_FALSE(read_back(changed(urdf, mass, "-" + mass)));
  EXPECT_FALSE(read_back(changed(urdf, "ixx=\"" + transverse + "\"", "")));
  EXPECT_FALSE(read_back(changed(urdf, axial, "1")));

  BodyFile heavier = body;
  heavier.properties.mass *= 1 + Number("3e-16");
  ASSERT_TRUE(read_back(as_sdf(heavier)));
  EXPECT_GT(error_of(*read_back(as_sdf(heavier)), body), 0);
}

TEST(BodyFormats, NamesThatMeanThemselves) {
  for (const auto* name : {"stone.obj", "White_33-1mm+v2.obj", "0"}) {
    EXPECT_TRUE(is_plain_name(name)) << name;
  }
  for (const auto* name :
       {"", "a b", "a&b", "<", "\"", "a/b", "%41", "\n", "\xE7\xA2\x81", "a?b", "a#b", "a\\b", "~"}) {
    EXPECT_FALSE(is_plain_name(name)) << name;
  }
}

}  // namespace
}  // namespace goishi::cli

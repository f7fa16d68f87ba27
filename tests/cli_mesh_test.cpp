/// The program `goishi`: mesh and body. What other programs make of the files is for tests/formats/.

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

#include "tests/cli_test.hpp"

namespace goishi::cli_test {

namespace {

class CliMesh : public Cli {
 protected:
  /// A file in the test's folder.
  [[nodiscard]] std::string path(const std::string& name) const { return (work() / name).string(); }

  [[nodiscard]] std::set<std::string> names() const {
    const std::vector<std::string> all = files();
    return {all.begin(), all.end()};
  }

  /// Runs the command, and expects that it prints nothing.
  void make(const std::string& command, const std::string& file) const {
    EXPECT_EQ(printed(words_of(command) + Words{"--output", path(file)}), "");
  }

  /// Expects the error, and no file.
  void expect_no_file(const std::string& command, const std::string& file, const std::string& line) const {
    expect_error(words_of(command) + Words{"--output", file}, line);
    EXPECT_TRUE(files().empty()) << command;
  }
};

const std::string mesh_33 = "mesh --size 33 --bevel 1mm --level 1 ";
const std::string body_33 = "body --size 33 --bevel 1mm --level 1 ";

/// The coordinates of an OBJ file's points.
std::vector<double> coordinates(const std::string& obj) {
  std::vector<double> numbers;
  std::istringstream lines(obj);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("v ")) {
      std::istringstream rest(line.substr(2));
      numbers.insert(numbers.end(), std::istream_iterator<double>(rest), {});
    }
  }
  return numbers;
}

// --- mesh

TEST_F(CliMesh, TheExtensionSaysTheFormat) {
  const std::pair<std::string, std::string> starts[] = {
      {"obj", "# goishi: lengths in m. The white stone of size 33,"},
      {"stl", "goishi: lengths in m. The white stone of size 33,"},
      {"ply", "ply\nformat binary_little_endian 1.0\ncomment goishi: "},
      {"glb", "glTF"}};
  for (const auto& [format, start] : starts) {
    make(mesh_33, "stone." + format);
    const std::string bytes = contents(path("stone." + format));
    EXPECT_EQ(bytes.substr(0, start.size()), start);
    make(mesh_33, "STONE." + std::string(format == "obj" ? "OBJ" : format));
    EXPECT_EQ(contents(path("STONE." + std::string(format == "obj" ? "OBJ" : format))), bytes);
    make(mesh_33 + "--format " + format, "stone.other");
    EXPECT_EQ(contents(path("stone.other")), bytes) << "the format goes before the extension";
    EXPECT_EQ(printed(words_of(mesh_33 + "--output - --format " + format)), bytes);
  }
}

TEST_F(CliMesh, UnitsScaleThePoints) {
  make(mesh_33, "m.obj");
  const std::vector<double> metres = coordinates(contents(path("m.obj")));
  ASSERT_GT(metres.size(), 30U);
  for (const auto& [unit, scale] : {std::pair<std::string, double>("m", 1), {"cm", 100}, {"mm", 1000}}) {
    make(mesh_33 + "--units " + unit, "scaled.obj");
    const std::string text = contents(path("scaled.obj"));
    EXPECT_NE(text.find("lengths in " + unit + "."), std::string::npos);
    std::vector<double> expected = metres;
    std::ranges::transform(expected, expected.begin(), [scale = scale](double x) { return x * scale; });
    EXPECT_EQ(coordinates(text), expected) << unit;
  }
  make(mesh_33 + "--units m", "stone.glb");
}

TEST_F(CliMesh, ReachesAsFarAsTheStone) {
  make("mesh --size 33 --bevel 1mm --level 4 --measured --units mm", "stone.obj");
  const std::vector<double> all = coordinates(contents(path("stone.obj")));
  double height = 0, width = 0;
  for (std::size_t i = 0; i < all.size(); i += 3) {
    width = std::max(width, std::hypot(all[i], all[i + 1]));
    height = std::max(height, all[i + 2]);
  }
  EXPECT_NEAR(width, 11, 1e-12);
  EXPECT_NEAR(height, 4.6, 1e-12);
}

TEST_F(CliMesh, Statistics) {
  const std::string text = printed(words_of(mesh_33 + "--stats"));
  for (const auto* line :
       {"The white stone of size 33, bevel 0.001 m, as a mesh by subdivision\n",
        "\nrings +2 +of triangles from the middle of a cap to its rim\n", "\nrows +1 +of triangles across the bevel\n",
        "\nsegments +10 +around the rim\n", "\ntriangles +60\n", "\nvertices +32 +points with a normal\n",
        "\npoints +32\n", "\ndeviation +0\\.000[0-9]+ +m +the largest distance from the stone\n",
        "\nvolume +1\\.[0-9]+e-06 +m³ +the stone's: 1.84302e-06\n",
        "\nsurface area +0\\.000[0-9]+ +m² +the stone's: 0.000871129\n"}) {
    EXPECT_TRUE(std::regex_search(text, std::regex(line))) << line << text;
  }
  EXPECT_TRUE(files().empty());
  EXPECT_EQ(printed(words_of(mesh_33 + "--stats --output " + path("stone.stl"))), text);
  const std::string sharp = printed(words_of("mesh --size 33 --level 1 --stats"));
  EXPECT_TRUE(std::regex_search(sharp, std::regex("\nvertices +32 .*\npoints +22\n"))) << sharp;
}

/// The triangles of an OBJ file by their points, each from its least one on.
std::multiset<std::vector<double>> triangles_of(const std::string& obj) {
  const std::vector<double> all = coordinates(obj);
  std::multiset<std::vector<double>> triangles;
  std::istringstream lines(obj);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("f ")) {
      std::vector<std::vector<double>> corners;
      std::istringstream rest(line.substr(2));
      for (std::string corner; rest >> corner;) {
        const auto at = all.begin() + 3 * (std::stol(corner) - 1);
        corners.emplace_back(at, at + 3);
      }
      std::ranges::rotate(corners, std::ranges::min_element(corners));
      std::vector<double> triangle;
      for (const std::vector<double>& corner : corners) {
        triangle.insert(triangle.end(), corner.begin(), corner.end());
      }
      triangles.insert(triangle);
    }
  }
  return triangles;
}

TEST_F(CliMesh, TheCachesOrderIsOfTheSameTriangles) {
  for (const std::string& options : {std::string("--bevel 1mm "), std::string("--method rings ")}) {
    const std::string command = "mesh --size 33 --level 4 " + options;
    make(command, "plain.obj");
    make(command + "--cache-order", "ordered.obj");
    const std::string plain = contents(path("plain.obj")), ordered = contents(path("ordered.obj"));
    EXPECT_NE(plain, ordered);
    EXPECT_EQ(triangles_of(plain), triangles_of(ordered));
    const auto misses = [&](const std::string& more) {
      std::smatch found;
      const std::string text = printed(words_of(command + "--stats" + more));
      EXPECT_TRUE(std::regex_search(text, found, std::regex("\ncache misses +([0-9.]+) ")));
      return std::stod(found[1]);
    };
    EXPECT_LT(misses(" --cache-order"), 0.8);
    EXPECT_LT(misses(" --cache-order"), 0.8 * misses(""));
  }
}

TEST_F(CliMesh, TheToleranceIsKept) {
  for (const std::string& method : {std::string("subdivision"), std::string("rings")}) {
    for (const double micrometres : {100.0, 10.0, 1.0}) {
      const std::string text = printed(words_of("mesh --size 33 --bevel 1mm --stats --method " + method +
                                                " --tolerance " + std::to_string(micrometres) + "um"));
      std::smatch match;
      ASSERT_TRUE(std::regex_search(text, match, std::regex("\ndeviation +([0-9.e-]+)"))) << text;
      EXPECT_LE(std::stod(match[1]), 1e-6 * micrometres);
      EXPECT_GT(std::stod(match[1]), 0.5e-6 * micrometres) << "no more triangles than it takes";
      EXPECT_NE(text.find("as a mesh by " + method), std::string::npos);
    }
  }
}

TEST_F(CliMesh, BadInput) {
  const std::string stone = "mesh --size 33 ", file = path("stone.obj");
  const std::string formats = ": must end in .obj, .stl, .ply or .glb, or --format be given too";
  expect_error(words_of(stone), "a file is needed: --output, such as --output stone.glb (or --stats)");
  expect_no_file("mesh", file, "a stone is needed: --size, or --width and --height");
  expect_no_file(stone, path("stone.xyz"), "output = " + path("stone.xyz") + formats);
  expect_no_file(stone, path("stone"), "output = " + path("stone") + formats);
  expect_no_file(stone, "", "output = " + formats);
  expect_no_file(stone, "/nonexistent/x.obj",
                 "output = /nonexistent/x.obj: cannot be written: No such file or directory");
  expect_no_file(stone, "-", "output = -: needs --format too");
  expect_no_file(stone + "--format obj --stats", "-", "output = -: must be a file with --stats, which are printed");
  expect_no_file(stone + "--format xyz", file, "format = xyz: must be obj, stl, ply or glb");
  expect_no_file(stone + "--units inch", file, "units = inch: must be m, cm or mm");
  expect_no_file(stone + "--units mm", path("x.glb"), "units = mm: must be m in glb, whose unit is the metre");
  expect_no_file(stone + "--method cubes", file, "method = cubes: must be subdivision or rings");
  expect_no_file(stone + "--level 99", file, "level = 99: must be a whole number from 0 to 8");
  expect_no_file(stone + "--level -1", file, "level = -1: must be a whole number from 0 to 8");
  expect_no_file(stone + "--level 9 --method rings", file, "level = 9: must be a whole number from 0 to 8");
  expect_no_file(stone + "--level 2 --tolerance 1um", file, "tolerance = 1um: must not be given with --level (2)");
  expect_no_file(stone + "--tolerance 0", file, "tolerance = 0: must be positive and finite");
  expect_no_file(stone + "--tolerance -1mm", file, "tolerance = -1mm: must be positive and finite");
  const std::string in_double =
      ": must, in SI units, be 0 or from 1e-20 to 1e20 in magnitude: a mesh computes in double";
  expect_no_file(stone + "--tolerance 1e-30", file, "tolerance = 1e-30" + in_double);
  expect_no_file("mesh --width 1e21 --height 1", file, "width = 1e21" + in_double);
  expect_no_file("mesh --width 1 --height 2", file, "height = 2: must not exceed the width (1)");
  expect_error(words_of("mesh --size 33 --stats --format obj"), "format = obj: needs --output too");
  expect_error(words_of("mesh --size 33 --stats --units mm"), "units = mm: needs --output too");
  const Result below = run(words_of(stone + "--tolerance 1e-19 --output " + file));
  EXPECT_EQ(below.status, 2);
  EXPECT_TRUE(below.err.starts_with("goishi: error: tolerance = 1e-19: must ")) << below.err;
  EXPECT_EQ(std::ranges::count(below.err, '\n'), 1);
  EXPECT_TRUE(files().empty());
}

TEST_F(CliMesh, NoPartialFileWhenThereIsNoRoom) {
  for (const std::string& name : {std::string("stone.glb"), std::string("stone.obj")}) {
    const Result result = run(words_of("mesh --size 33 --output " + path(name)), "ulimit -f 1; ");
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err, "goishi: error: output = " + path(name) + ": cannot be written: File too large\n");
    EXPECT_TRUE(files().empty());
  }
}

// --- body

TEST_F(CliMesh, ABodyAndItsMeshStandSideBySide) {
  for (const auto& [file, start] :
       {std::pair<std::string, std::string>("stone.urdf", "<robot"), {"stone.sdf", "<sdf"}, {"stone.xml", "<mujoco"}}) {
    make(body_33, file);
    EXPECT_EQ(names(), (std::set<std::string>{file, "stone.obj"}));
    const std::string text = contents(path(file));
    EXPECT_NE(text.find(start), std::string::npos);
    EXPECT_NE(text.find("The white stone of size 33, bevel 0.001 m"), std::string::npos);
    EXPECT_NE(text.find("stone.obj"), std::string::npos);
    EXPECT_EQ(text.find(work().string()), std::string::npos) << "no path";
    make(mesh_33, "mesh.obj");
    EXPECT_EQ(contents(path("stone.obj")), contents(path("mesh.obj")));
    const auto mode = [this](const std::string& name) { return fs::status(path(name)).permissions(); };
    EXPECT_EQ(mode(file), mode("mesh.obj"));
    EXPECT_EQ(mode("stone.obj"), mode("mesh.obj"));
    for (const std::string& name : names()) {
      fs::remove(path(name));
    }
  }
  make(body_33 + "--format urdf", "stone.xml");
  EXPECT_NE(contents(path("stone.xml")).find("<robot"), std::string::npos) << "the format goes before the extension";
  make(body_33, "stone.mjcf");
  EXPECT_NE(contents(path("stone.mjcf")).find("<mujoco"), std::string::npos);
}

TEST_F(CliMesh, ABodyHasTheDigitsOfInertia) {
  for (const std::string& stone : {std::string("--size 33 --bevel 1mm "), std::string("--size 22 --mass 5g "),
                                   std::string("--width 1 --height 0.4 --density 1.5g/cm3 --bevel 0.1 --measured ")}) {
    const std::string json = printed(words_of("inertia --format json " + stone));
    for (const auto* format : {"urdf", "sdf", "mjcf"}) {
      make("body --level 0 " + stone + "--format " + format, "stone.file");
      const std::string text = contents(path("stone.file"));
      for (const auto* key : {"mass", "axial", "transverse"}) {
        std::smatch match;
        ASSERT_TRUE(std::regex_search(json, match, std::regex("\"" + std::string(key) + "\": ([^,\n]+)")));
        EXPECT_NE(text.find(match[1].str()), std::string::npos) << format << key << text;
      }
    }
  }
}

TEST_F(CliMesh, BadBodies) {
  const std::string stone = "body --size 33 ", file = path("stone.urdf");
  expect_error(words_of(stone), "a file is needed: --output, such as --output stone.urdf");
  expect_no_file("body", file, "a stone is needed: --size, or --width and --height");
  const std::string formats = ": must end in .urdf, .sdf, .mjcf or .xml, or --format be given too";
  expect_no_file(stone, path("stone.xyz"), "output = " + path("stone.xyz") + formats);
  expect_no_file(stone, "", "output = " + formats);
  expect_no_file(stone + "--format xml", file, "format = xml: must be urdf, sdf or mjcf");
  expect_no_file(stone + "--format urdf", "-", "output = -: must be a file: the mesh is written beside it");
  expect_no_file(stone + "--format urdf", path("a.obj"),
                 "output = " + path("a.obj") + ": must not end in .obj, as the mesh beside it does");
  for (const std::string& name : {std::string("a b.urdf"), std::string("a&b.urdf"), std::string("碁石.urdf")}) {
    expect_no_file(stone, path(name),
                   "output = " + path(name) +
                       ": must have a file name of ASCII letters, digits, '.', '_', '-' and '+': the body's file holds "
                       "the name of the mesh's");
  }
  expect_no_file(
      stone, "/nonexistent/x.urdf",
      "output = /nonexistent/x.urdf: needs /nonexistent/x.obj too, which cannot be written: No such file or directory");
  expect_no_file(stone + "--mass 0", file, "mass = 0: must be positive and finite");
  expect_no_file(stone + "--mass -5g", file, "mass = -5g: must be positive and finite");
  expect_no_file(
      stone + "--mass 1e-30", file,
      "mass = 1e-30: must, in SI units, be 0 or from 1e-20 to 1e20 in magnitude: a simulator computes in double");
  expect_no_file(stone + "--mass 5g --density 2700", file, "density = 2700: must not be given with --mass (5g)");
  expect_no_file(stone + "--level 9", file, "level = 9: must be a whole number from 0 to 8");
  expect_error(words_of("body --size 33 --format urdf --output /dev/null"),
               "output = /dev/null: must be a file that can be replaced");
  EXPECT_FALSE(fs::exists("/dev/null.obj"));
}

TEST_F(CliMesh, ABodyAndItsMeshAreBothWrittenOrNeither) {
  // There is room for the body's file, but not for the mesh.
  const std::string file = path("stone.urdf");
  const Result fresh = run(words_of("body --size 33 --output " + file), "ulimit -f 8; ");
  EXPECT_EQ(fresh.status, 2);
  EXPECT_EQ(fresh.err, "goishi: error: output = " + file + ": needs " + path("stone.obj") +
                           " too, which cannot be written: File too large\n");
  EXPECT_TRUE(files().empty());

  // Where the body's file would stand, there is a folder; where the mesh would.
  fs::create_directory(file);
  expect_error(words_of(body_33 + "--output " + file), "output = " + file + ": must be a file that can be replaced");
  EXPECT_EQ(names(), (std::set<std::string>{"stone.urdf"}));
  fs::remove(file);
  fs::create_directory(path("stone.obj"));
  expect_error(words_of(body_33 + "--output " + file),
               "output = " + file + ": needs " + path("stone.obj") + " too, which is no file that can be replaced");
  EXPECT_EQ(names(), (std::set<std::string>{"stone.obj"}));
}

}  // namespace
}  // namespace goishi::cli_test

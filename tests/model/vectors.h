#pragma once
/// Reads the conformance vectors of tests/data/vectors (see the README there).
#include <zlib.h>

#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/engine.h"
#include "traces/format/records.h"

namespace kagesen {

inline constexpr const char* kVectorScenes[] = {"cubes_rot", "glyphs", "slivers", "torus"};
inline constexpr std::uint32_t kVectorGround = 255;  ///< the object that is not drawn in pass 1

/// A scene and the exact verdict of every fragment, 1 = dark.
struct ExactVectors {
  Trace trace;  ///< casters in file order; polygon as in the file
  std::vector<std::uint8_t> paper, physical;
};

/// An entry of the silhouette buffer and the End flags as the file has them.
struct SlbVectors {
  std::vector<TexelEntry> entries;  ///< in file order; start_here of a line is not in the file
};

/// Calls line(const char*) for every line of a gzip file.
template <class Line>
void for_each_gzip_line(const std::string& path, Line line) {
  gzFile file = gzopen(path.c_str(), "rb");
  if (file == nullptr) throw std::runtime_error("cannot open " + path);
  char buffer[256];
  while (gzgets(file, buffer, sizeof buffer) != nullptr) line(buffer);
  const bool whole = gzeof(file) != 0;
  gzclose(file);
  if (!whole) throw std::runtime_error("damaged: " + path);
}

inline std::string vector_path(const std::string& file) {
  return std::string(KAGESEN_TEST_DATA) + "/vectors/" + file;
}

[[noreturn]] inline void reject_vector_line(const char* text) {
  throw std::runtime_error(std::string("unreadable vector line: ") + text);
}

/// At scale S the geometry is the same and a texel has S x 65,536 units; S is a power of two.
inline ExactVectors read_exact_vectors(const std::string& scene, int scale = 1) {
  ExactVectors v;
  std::vector<LightPoint> vertices;
  for_each_gzip_line(vector_path(scene + ".exact.txt.gz"), [&](const char* text) {
    LightPoint p;
    unsigned a, b, c, object, polygon, paper, physical;
    int side;
    if (text[0] == '#') return;
    if (std::sscanf(text, "v %d %d %u", &p.x, &p.y, &p.z) == 3) {
      vertices.push_back(p);
    } else if (std::sscanf(text, "t %u %u %u obj %u poly %u side %d", &a, &b, &c, &object, &polygon,
                           &side) == 6) {
      if (side != 1 || object == kVectorGround) return;
      v.trace.all_casters.push_back(
          {{vertices.at(a), vertices.at(b), vertices.at(c)}, object, polygon});
    } else if (std::sscanf(text, "f %d %d %u obj %u paper %u phys %u", &p.x, &p.y, &p.z, &object,
                           &paper, &physical) == 6) {
      Fragment f;
      f.position = p;
      f.object = object;
      f.flags = Fragment::kVisible;
      v.trace.all_fragments.push_back(f);
      v.paper.push_back(std::uint8_t(paper));
      v.physical.push_back(std::uint8_t(physical));
    } else {
      reject_vector_line(text);
    }
  });
  v.trace.header.source = scene;
  v.trace.header.scale_x = v.trace.header.scale_y = scale;
  while (scale > 1) {
    scale /= 2;
    ++v.trace.header.fraction_bits;
  }
  v.trace.header.objects.resize(kVectorGround + 1);
  v.trace.header.objects[kVectorGround].caster = false;
  return v;
}

inline SlbVectors read_slb_vectors(const std::string& scene, int scale, int bits) {
  SlbVectors v;
  const std::string file =
      scene + ".scale" + std::to_string(scale) + ".bits" + std::to_string(bits) + ".slb.txt.gz";
  for_each_gzip_line(vector_path(file), [&](const char* text) {
    TexelEntry e;
    LineRecord l;
    unsigned vertex, end, left, cross, x_major, x_positive;
    if (text[0] == '#') return;
    if (std::sscanf(text, "e x %u y %u obj %u z %u vertex %u", &e.texel_x, &e.texel_y, &e.object,
                    &e.nearest, &vertex) == 5) {
      e.vertex = vertex != 0;
      v.entries.push_back(e);
    } else if (!v.entries.empty() &&
               std::sscanf(text,
                           " l frac %u slope %u end %u left %u cross %u xmajor %u xpos %u poly %u",
                           &l.fraction, &l.slope, &end, &left, &cross, &x_major, &x_positive,
                           &l.polygon) == 8) {
      l.end_here = end != 0;
      l.left = left != 0;
      l.cross = cross != 0;
      l.x_major = x_major != 0;
      l.x_positive = x_positive != 0;
      v.entries.back().lines.push_back(l);
    } else {
      reject_vector_line(text);
    }
  });
  return v;
}

}  // namespace kagesen

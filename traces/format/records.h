#pragma once
/// The records of a trace: what the rasteriser hands to a shadow unit, in integers.
///
/// Light space is signed fixed point. The origin is a texel corner: texel (i, j) of a W x H map
/// covers x in [(i - W/2) T, (i + 1 - W/2) T), y likewise, with T = 2^fraction_bits units a texel
/// and W/2, H/2 rounded down. y grows with the row. Depth is unsigned and grows away from the
/// light.
#include <cstdint>
#include <string>
#include <vector>

namespace kagesen {

inline constexpr int kCoordinateBits = 28;  ///< of x and y, sign included
inline constexpr std::int32_t kCoordinateMax = (1 << (kCoordinateBits - 1)) - 1;
inline constexpr std::int32_t kCoordinateMin = -(1 << (kCoordinateBits - 1));
inline constexpr int kDepthBits = 24;
inline constexpr std::uint32_t kDepthMax = (1u << kDepthBits) - 1;
inline constexpr int kMinFractionBits = 16;
inline constexpr int kMaxFractionBits = 26;
inline constexpr std::uint32_t kMaxMapSide = 4096;

/// A point in light space. x, y: units of 2^-fraction_bits texel; z: 24-bit depth.
struct LightPoint {
  std::int32_t x = 0, y = 0;
  std::uint32_t z = 0;
};

/// One triangle of pass 1. Its outline is what counts: either winding may occur.
struct Caster {
  LightPoint vertex[3];
  std::uint32_t object = 0;   ///< index into TraceHeader::objects
  std::uint32_t polygon = 0;  ///< number of the triangle in its scene; further pieces of a clipped
                              ///< one are numbered after the scene's last triangle
};

/// One sample of pass 2.
struct Fragment {
  enum Flag : std::uint8_t {
    kAverted = 1,  ///< its surface faces away from the light: dark by definition
    kVisible = 2,  ///< the sample that the camera finally sees at its pixel
    kOutside = 4,  ///< outside the light's frustum: lit by definition; position is clamped
  };
  LightPoint position;
  std::uint32_t object = 0;
  std::uint16_t pixel_x = 0, pixel_y = 0;  ///< from the image's upper left corner
  std::uint8_t shade = 255;                ///< Lambert term, UQ0.8, for pictures only
  std::uint8_t flags = 0;                  ///< of Flag
};

/// What a trace says of one object.
struct ObjectInfo {
  std::string name;
  std::uint32_t triangles = 0;  ///< in the scene, before culling and clipping
  bool closed = false;          ///< closed 2-manifold: only its light-facing triangles are casters
  bool caster = true;           ///< false: a pure receiver (the ground)
};

enum class FragmentMode : std::uint8_t { kVisible, kEarlyZ, kAll };

/// Everything but the records themselves.
struct TraceHeader {
  std::uint32_t map_width = 1024, map_height = 1024;  ///< texels, 1 to kMaxMapSide
  std::uint32_t fraction_bits = kMinFractionBits;     ///< units a texel = 2^fraction_bits, 16 to 26
  double scale_x = 1, scale_y = 1;                  ///< virtual projection space, 1 to 1024 an axis
  std::uint32_t image_width = 0, image_height = 0;  ///< pixels
  FragmentMode mode = FragmentMode::kVisible;
  std::string source;                 ///< scene or file name
  std::string source_sha256;          ///< of the file, or of the built-in scene's geometry
  std::string light;                  ///< in words, for example "directional"
  std::uint64_t seed = 0;             ///< of the built-in scene's generator; 0 where none is used
  std::vector<std::string> warnings;  ///< what the import and the capture had to drop or change
  std::vector<ObjectInfo> objects;
};

/// Takes a trace as a stream: begin, then casters in any portions, then fragments, then end.
class TraceSink {
 public:
  virtual ~TraceSink() = default;
  virtual void begin(const TraceHeader& header) = 0;
  virtual void casters(const Caster* first, std::size_t count) = 0;
  virtual void fragments(const Fragment* first, std::size_t count) = 0;
  virtual void end() = 0;
};

/// A whole trace in memory.
struct Trace : TraceSink {
  TraceHeader header;
  std::vector<Caster> all_casters;
  std::vector<Fragment> all_fragments;

  void begin(const TraceHeader& h) override { header = h; }
  void casters(const Caster* first, std::size_t count) override {
    all_casters.insert(all_casters.end(), first, first + count);
  }
  void fragments(const Fragment* first, std::size_t count) override {
    all_fragments.insert(all_fragments.end(), first, first + count);
  }
  void end() override {}
};

}  // namespace kagesen

#include <functional>
#include <future>
#include <vector>

#include "sim/report/encode.h"
#include "sim/report/pictures.h"

namespace kagesen {

void write_pictures(const Trace& trace, const RunResult& result, const std::string& folder,
                    Outputs& outputs) {
  struct Picture {
    std::string name;
    std::function<std::string()> encode;
  };
  const int width = static_cast<int>(trace.header.image_width);
  const int height = static_cast<int>(trace.header.image_height);
  std::vector<Picture> pictures;
  if (width > 0 && height > 0) {
    pictures.push_back(
        {"shaded.png", [&] { return encode_png(shaded_picture(trace, result.verdicts)); }});
    pictures.push_back(
        {"mask.png",
         [&] { return encode_png_grey(width, height, mask_values(trace, result.verdicts)); }});
    if (result.judgement) {
      pictures.push_back({"errors.png", [&] { return encode_png(error_picture(trace, result)); }});
    }
  }
  pictures.push_back({"lines.png", [&] { return encode_png(lines_picture(result)); }});
  if (width > 0 && height > 0 && !result.fragment_cycles.empty()) {
    pictures.push_back({"cycles.png", [&] { return encode_png(cycle_picture(trace, result)); }});
  }
  if (result.cycles) {
    pictures.push_back(
        {"map_cycles.png", [&] { return encode_png(map_cycle_picture(trace, result)); }});
  }
  if (width > 0 && height > 0) {
    pictures.push_back({"frame.exr", [&] { return frame_exr(trace, result); }});
  }
  pictures.push_back({"map.exr", [&] { return map_exr(result); }});

  std::vector<std::future<std::string>> encoded;
  for (const Picture& picture : pictures) {
    encoded.push_back(std::async(std::launch::async, picture.encode));
  }
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    outputs.write(folder + "/" + pictures[i].name, encoded[i].get(), "--out");
  }
}

}  // namespace kagesen

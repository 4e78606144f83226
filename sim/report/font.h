#pragma once
/// A 5 x 7 bitmap font: capitals, digits and the signs that legends need, so that pictures look the
/// same on every machine, whatever fonts it has.
namespace kagesen {

inline constexpr int kGlyphWidth = 5, kGlyphHeight = 7;

/// Is the pixel set? Small letters look like capitals; a character without a glyph like a blank.
bool glyph_bit(char letter, int column, int row);

}  // namespace kagesen

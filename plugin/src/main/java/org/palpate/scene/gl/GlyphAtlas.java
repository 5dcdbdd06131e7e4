package org.palpate.scene.gl;

import com.jogamp.common.nio.Buffers;
import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.nio.ByteBuffer;

/** The glyphs of one text size in one texture. */
final class GlyphAtlas {
  private static final String EXTRA = "–—→←↑↓≥≤…▸■□";
  private static final int FIRST = 32;
  private static final int PLAIN = 95;

  /** Letters of western European languages, which names of segments may contain. */
  private static final int FIRST_LATIN = 160;

  private static final int LATIN = 96;
  private static final int COLUMNS = 16;

  private final int[] texture = new int[1];
  private final int cellWidth;
  private final int cellHeight;
  private final int ascent;
  private final int[] advance = new int[PLAIN + LATIN + EXTRA.length()];
  private final int width;
  private final int height;

  /** Draws the glyphs of a size in pixels. */
  GlyphAtlas(GL3 gl, int sizePixels) {
    Font font = new Font(Font.SANS_SERIF, Font.PLAIN, sizePixels);
    BufferedImage probe = new BufferedImage(1, 1, BufferedImage.TYPE_BYTE_GRAY);
    Graphics2D measuring = probe.createGraphics();
    FontMetrics metrics = measuring.getFontMetrics(font);
    measuring.dispose();
    ascent = metrics.getAscent();
    cellHeight = metrics.getAscent() + metrics.getDescent() + 2;
    int widest = 0;
    for (int i = 0; i < advance.length; i++) {
      advance[i] = metrics.charWidth(character(i));
      widest = Math.max(widest, advance[i]);
    }
    cellWidth = widest + 4;
    width = COLUMNS * cellWidth;
    height = (advance.length + COLUMNS - 1) / COLUMNS * cellHeight;
    upload(gl, paint(font));
  }

  private static char character(int index) {
    if (index < PLAIN) {
      return (char) (FIRST + index);
    }
    int latin = index - PLAIN;
    return latin < LATIN ? (char) (FIRST_LATIN + latin) : EXTRA.charAt(latin - LATIN);
  }

  private static int index(char character) {
    if (character >= FIRST && character < FIRST + PLAIN) {
      return character - FIRST;
    }
    if (character >= FIRST_LATIN && character < FIRST_LATIN + LATIN) {
      return PLAIN + character - FIRST_LATIN;
    }
    int extra = EXTRA.indexOf(character);
    return extra >= 0 ? PLAIN + LATIN + extra : '?' - FIRST;
  }

  private BufferedImage paint(Font font) {
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_BYTE_GRAY);
    Graphics2D graphics = image.createGraphics();
    graphics.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    graphics.setRenderingHint(
        RenderingHints.KEY_FRACTIONALMETRICS, RenderingHints.VALUE_FRACTIONALMETRICS_OFF);
    graphics.setFont(font);
    graphics.setColor(Color.WHITE);
    for (int i = 0; i < advance.length; i++) {
      int x = i % COLUMNS * cellWidth + 2;
      int y = i / COLUMNS * cellHeight + 1 + ascent;
      graphics.drawString(String.valueOf(character(i)), x, y);
    }
    graphics.dispose();
    return image;
  }

  private void upload(GL3 gl, BufferedImage image) {
    byte[] grey = new byte[width * height];
    image.getRaster().getDataElements(0, 0, width, height, grey);
    ByteBuffer bytes = Buffers.newDirectByteBuffer(grey);
    gl.glGenTextures(1, texture, 0);
    gl.glBindTexture(GL.GL_TEXTURE_2D, texture[0]);
    GreyTexture.upload(gl, width, height, bytes);
  }

  /** Returns the texture. */
  int texture() {
    return texture[0];
  }

  /** Returns the height of a line, pixels. */
  int lineHeight() {
    return cellHeight;
  }

  /** Returns the width of a text, pixels. */
  int width(String text) {
    return text.chars().map(c -> advance[index((char) c)]).sum();
  }

  /**
   * Adds a line of text to a batch. It begins at a whole pixel, so that each glyph keeps its own
   * cell of the texture.
   *
   * @param x left edge, pixels from the left
   * @param y upper edge, pixels from the top
   */
  void add(OverlayBatch batch, String text, double x, double y) {
    double at = Math.rint(x);
    double upper = Math.rint(y);
    for (int i = 0; i < text.length(); i++) {
      int index = index(text.charAt(i));
      double left = index % COLUMNS * cellWidth;
      double top = index / COLUMNS * cellHeight;
      batch.rectangle(
          at - 2,
          upper,
          at - 2 + cellWidth,
          upper + cellHeight,
          left / width,
          top / height,
          (left + cellWidth) / width,
          (top + cellHeight) / height);
      at += advance[index];
    }
  }

  /** Releases the texture. */
  void dispose(GL3 gl) {
    gl.glDeleteTextures(1, texture, 0);
  }
}

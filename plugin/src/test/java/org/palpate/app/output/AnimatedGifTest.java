package org.palpate.app.output;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Color;
import java.awt.Graphics;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.metadata.IIOMetadataNode;
import org.junit.jupiter.api.Test;

class AnimatedGifTest {
  private static final Color[] COLOURS = {Color.RED, Color.GREEN, Color.BLUE};

  private static byte[] film() throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (AnimatedGif film = new AnimatedGif(out)) {
      for (int n = 0; n < COLOURS.length; n++) {
        BufferedImage picture = new BufferedImage(40, 20, BufferedImage.TYPE_INT_RGB);
        Graphics graphics = picture.getGraphics();
        graphics.setColor(COLOURS[n]);
        graphics.fillRect(0, 0, 40, 20);
        film.add(picture, 0.25 * (n + 1));
      }
    }
    return out.toByteArray();
  }

  @Test
  void showsEachPictureForItsTime() throws IOException {
    ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
    reader.setInput(ImageIO.createImageInputStream(new ByteArrayInputStream(film())));
    assertEquals(COLOURS.length, reader.getNumImages(true));
    for (int n = 0; n < COLOURS.length; n++) {
      BufferedImage picture = reader.read(n);
      assertEquals(40, picture.getWidth());
      assertEquals(20, picture.getHeight());
      assertEquals(COLOURS[n].getRGB(), picture.getRGB(20, 10));
      IIOMetadataNode root =
          (IIOMetadataNode) reader.getImageMetadata(n).getAsTree("javax_imageio_gif_image_1.0");
      IIOMetadataNode control =
          (IIOMetadataNode) root.getElementsByTagName("GraphicControlExtension").item(0);
      assertEquals(Integer.toString(25 * (n + 1)), control.getAttribute("delayTime"));
    }
  }

  @Test
  void repeatsWithoutEnd() throws IOException {
    byte[] bytes = film();
    String text = new String(bytes, StandardCharsets.ISO_8859_1);
    int at = text.indexOf("NETSCAPE2.0");
    assertEquals(at, text.lastIndexOf("NETSCAPE2.0"), "it stands in the file once");
    assertEquals("\u0003\u0001\u0000\u0000", text.substring(at + 11, at + 15));
  }
}

package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Renders fragments that a table of poses moves, as pictures and as a film. */
class FilmCommandTest {
  /** Colours of a GIF differ from those of the picture by less than this, mean of 0 to 255. */
  private static final double PALETTE_ERROR = 3;

  @TempDir private Path folder;

  @BeforeEach
  void writePoses() throws IOException {
    Files.writeString(
        folder.resolve("p.csv"),
        """
        frame,body,x,y,z,qw,qx,qy,qz
        100,fragment2,0,0,10,1,0,0,0
        100,fragment3,0,0,10,1,0,0,0
        5000,fragment2,0,0,0,1,0,0,0
        5001,fragment3,0,0,0,1,0,0,0
        """);
  }

  private BufferedImage picture(String name, Object... options) throws IOException {
    Path file = folder.resolve(name);
    List<Object> all = new ArrayList<>(List.of("render", "--phantom", "fracture:64:3"));
    all.addAll(List.of("--size", "160x120", "--out", file));
    all.addAll(List.of(options));
    CommandRun.of(all.toArray()).mustSucceed();
    return ImageIO.read(file.toFile());
  }

  private static double difference(BufferedImage one, BufferedImage other) {
    double sum = 0;
    for (int y = 0; y < one.getHeight(); y++) {
      for (int x = 0; x < one.getWidth(); x++) {
        for (int shift = 0; shift < 24; shift += 8) {
          int a = one.getRGB(x, y) >> shift & 255;
          int b = other.getRGB(x, y) >> shift & 255;
          sum += Math.abs(a - b);
        }
      }
    }
    return sum / (3 * one.getWidth() * one.getHeight());
  }

  @Test
  void aFilmLeadsFromTheStartToTheEndOfTheTable() throws IOException {
    Path poses = folder.resolve("p.csv");
    BufferedImage start = picture("start.png");
    BufferedImage end = picture("end.png", "--poses", poses);
    picture("film.gif", "--poses", poses, "--pictures", 3);
    assertTrue(difference(start, end) > PALETTE_ERROR, "the fragments moved");
    ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
    try (ImageInputStream film =
        ImageIO.createImageInputStream(folder.resolve("film.gif").toFile())) {
      reader.setInput(film);
      assertEquals(3, reader.getNumImages(true));
      assertEquals(0, difference(start, reader.read(0)), PALETTE_ERROR);
      assertEquals(0, difference(end, reader.read(2)), PALETTE_ERROR);
      BufferedImage between = reader.read(1);
      assertTrue(difference(reader.read(0), between) > PALETTE_ERROR, "it has left the start");
      assertTrue(difference(reader.read(2), between) > PALETTE_ERROR, "and is not at the end");
    }
  }

  @Test
  void aFilmNeedsBodiesThatMove() {
    Path poses = folder.resolve("p.csv");
    Path film = folder.resolve("film.gif");
    String refusal =
        CommandRun.of("render", "--phantom", "fracture:64:3", "--out", film).mustRefuse();
    assertTrue(refusal.contains("nothing moves in the film: --out " + film), refusal);
    refusal =
        CommandRun.of("render", "--phantom", "sphere:32", "--poses", poses, "--out", film)
            .mustRefuse();
    assertTrue(refusal.contains("the volume has no bodies that move: --poses"), refusal);
    Object[] single = {
      "render", "--phantom", "fracture:64:3", "--poses", poses, "--pictures", 3, "--out", "x.png"
    };
    refusal = CommandRun.of(single).mustRefuse();
    assertTrue(refusal.contains("a single picture is written: --pictures"), refusal);
  }
}

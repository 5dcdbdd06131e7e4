package org.palpate.io;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.function.Executable;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

/** Reads small files: their values, or the reason why a reader refuses them. */
public final class ReadVolumes {
  private ReadVolumes() {}

  /** Returns the values as whole numbers with blanks between them, x fastest. */
  public static String values(VolumeReader reader) throws VolumeFormatException {
    ScalarVolume volume = GreyVolumes.read(reader);
    VoxelGrid grid = volume.grid();
    List<String> words = new ArrayList<>();
    for (int n = 0; n < grid.voxelCount(); n++) {
      int i = n % grid.sizeX();
      int j = n / grid.sizeX() % grid.sizeY();
      words.add("" + (int) volume.value(i, j, n / grid.sizeX() / grid.sizeY()));
    }
    return String.join(" ", words);
  }

  /** Returns the part of a refusal before the name of the file, which it must contain. */
  public static String refusal(Path file, Executable open) {
    String said = assertThrows(VolumeFormatException.class, open).getMessage();
    assertTrue(said.contains(": " + file + ": "), said);
    return said.substring(0, said.indexOf(": " + file));
  }
}

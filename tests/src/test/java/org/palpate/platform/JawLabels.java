package org.palpate.platform;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;

/** A segmentation as 3D Slicer writes it: label 7 is a lower jaw and label 9 an upper jaw. */
public final class JawLabels {
  private JawLabels() {}

  /**
   * Writes a volume whose slices 1 and 2 are the lower jaw, and slices 4 and 5 the upper one.
   *
   * @param edge number of voxels along i and j; there are 8 slices
   * @param space name of the axes in the header
   * @param directions steps along i, j and k, mm
   * @param moreFields further lines of the header, each with its end
   */
  public static Path write(Path file, int edge, String space, String directions, String moreFields)
      throws IOException {
    String header =
        """
        NRRD0004
        type: uint8
        dimension: 3
        sizes: %1$d %1$d 8
        space: %2$s
        space directions: %3$s
        space origin: (10,20,30)
        encoding: raw
        Segment0_ID:=S1
        Segment0_Name:=lower jaw
        Segment0_LabelValue:=7
        Segment1_ID:=S2
        Segment1_Name:=upper jaw
        Segment1_LabelValue:=9
        %4$s
        """
            .formatted(edge, space, directions, moreFields);
    byte[] text = header.getBytes(StandardCharsets.UTF_8);
    int slice = edge * edge;
    byte[] all = Arrays.copyOf(text, text.length + 8 * slice);
    Arrays.fill(all, text.length + slice, text.length + 3 * slice, (byte) 7);
    Arrays.fill(all, text.length + 4 * slice, text.length + 6 * slice, (byte) 9);
    return Files.write(file, all);
  }
}

package org.palpate.io.nrrd;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Map;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberText;
import org.palpate.io.format.Grids;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.LabelTable;
import org.palpate.io.volume.LabelTable.Label;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VoxelType;
import org.palpate.volume.VoxelGrid;

/** Makes the header of a NRRD with gzip data attached, and labels in the keys of 3D Slicer. */
public final class NrrdHeaderWriter {
  private NrrdHeaderWriter() {}

  /** Returns the bytes of the header, with the empty line that ends it. */
  public static byte[] of(VolumeHeader header, VoxelType type) {
    VoxelGrid grid = header.grid();
    StringBuilder text = new StringBuilder("NRRD0005\n");
    line(text, "type", typeName(type));
    line(text, "dimension", "3");
    line(text, spaceField(header), space(header));
    line(text, "sizes", grid.sizeX() + " " + grid.sizeY() + " " + grid.sizeZ());
    line(
        text,
        "space directions",
        vector(Grids.stepMm(grid, 0))
            + " "
            + vector(Grids.stepMm(grid, 1))
            + " "
            + vector(Grids.stepMm(grid, 2)));
    line(text, "kinds", "domain domain domain");
    line(text, "endian", "little");
    line(text, "encoding", "gzip");
    line(text, "space origin", vector(grid.gridToWorld(new Vec3(0.5, 0.5, 0.5), new Vec3())));
    header.labels().ifPresent(table -> labels(table, text));
    return text.append('\n').toString().getBytes(StandardCharsets.UTF_8);
  }

  private static void line(StringBuilder text, String field, String value) {
    text.append(field).append(": ").append(value).append('\n');
  }

  private static String spaceField(VolumeHeader header) {
    return header.coordinateSystem() == CoordinateSystem.UNKNOWN ? "space dimension" : "space";
  }

  private static String space(VolumeHeader header) {
    return switch (header.coordinateSystem()) {
      case LPS -> "left-posterior-superior";
      case RAS -> "right-anterior-superior";
      case LAS -> "left-anterior-superior";
      case UNKNOWN -> "3";
    };
  }

  private static String typeName(VoxelType type) {
    return switch (type) {
      case FLOAT32 -> "float";
      case FLOAT64 -> "double";
      default -> type.name().toLowerCase(Locale.ROOT);
    };
  }

  private static String vector(Vec3 v) {
    return "(" + number(v.x) + "," + number(v.y) + "," + number(v.z) + ")";
  }

  private static String number(double value) {
    return NumberText.text(value + 0.0); // no -0
  }

  private static void labels(LabelTable table, StringBuilder text) {
    int n = 0;
    for (Map.Entry<Long, Label> entry : table.labels().entrySet()) {
      String prefix = "Segment" + n + "_";
      Label label = entry.getValue();
      text.append(prefix).append("ID:=Segment_").append(entry.getKey()).append('\n');
      text.append(prefix).append("Name:=").append(oneLine(label.name())).append('\n');
      text.append(prefix).append("LabelValue:=").append(entry.getKey()).append('\n');
      text.append(prefix).append("Layer:=0\n");
      text.append(prefix).append("Color:=").append(color(label.rgb())).append('\n');
      n++;
    }
  }

  private static String color(int rgb) {
    return number((rgb >> 16 & 255) / 255.0)
        + " "
        + number((rgb >> 8 & 255) / 255.0)
        + " "
        + number((rgb & 255) / 255.0);
  }

  private static String oneLine(String name) {
    return name.replaceAll("\\p{Cntrl}", " ");
  }
}

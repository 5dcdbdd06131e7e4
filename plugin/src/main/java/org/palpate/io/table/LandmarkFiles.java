package org.palpate.io.table;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.palpate.io.file.AtomicFile;
import org.palpate.io.file.NumberText;

/** Writes landmarks as a table and as a markups file for 3D Slicer. For one thread. */
public final class LandmarkFiles {
  private LandmarkFiles() {}

  /**
   * Writes {@code name,x,y,z} with coordinates in world mm.
   *
   * @throws IOException if the file cannot be written; the target is then unchanged
   */
  public static void writeCsv(Path target, List<Landmark> landmarks) throws IOException {
    write(target, landmarks, "name,x,y,z\n", LandmarkFiles::csvRow);
  }

  /**
   * Writes 3D Slicer's fiducial format, version 4.11, with LPS coordinates as in DICOM: x to the
   * left, y to the back, z to the head. The world coordinates are taken to be LPS.
   *
   * @throws IOException if the file cannot be written; the target is then unchanged
   */
  public static void writeFcsv(Path target, List<Landmark> landmarks) throws IOException {
    String head =
        """
        # Markups fiducial file version = 4.11
        # CoordinateSystem = LPS
        # columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID
        """;
    write(target, landmarks, head, LandmarkFiles::fcsvRow);
  }

  private interface Row {
    String of(Landmark landmark, int index);
  }

  private static void write(Path target, List<Landmark> landmarks, String head, Row row)
      throws IOException {
    try (AtomicFile file = new AtomicFile(target)) {
      Writer writer =
          new BufferedWriter(new OutputStreamWriter(file.stream(), StandardCharsets.UTF_8));
      writer.write(head);
      for (int n = 0; n < landmarks.size(); n++) {
        writer.write(row.of(landmarks.get(n), n));
      }
      writer.flush();
      file.commit();
    }
  }

  private static String csvRow(Landmark landmark, int index) {
    return CsvWriter.quoted(landmark.name()) + "," + coordinates(landmark) + "\n";
  }

  private static String fcsvRow(Landmark landmark, int index) {
    return "vtkMRMLMarkupsFiducialNode_"
        + index
        + ","
        + coordinates(landmark)
        + ",0,0,0,1,1,1,0,"
        + CsvWriter.quoted(landmark.name())
        + ",,\n";
  }

  private static String coordinates(Landmark landmark) {
    return NumberText.text(landmark.worldMm().x)
        + ","
        + NumberText.text(landmark.worldMm().y)
        + ","
        + NumberText.text(landmark.worldMm().z);
  }
}

package org.palpate.io.table;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.edit.VoxelChange;
import org.palpate.volume.VoxelGrid;

class EditsCsvTest {
  private static final VoxelGrid GRID = VoxelGrid.ofUnitVoxels(8, 6, 4);
  private static final List<String> SEGMENTS = List.of("bone", "skin");

  @TempDir private Path folder;

  private List<VoxelChange> read(String text) throws IOException {
    Path file = Files.writeString(folder.resolve("e.csv"), text);
    return EditsCsv.read(file, SEGMENTS, List.of(GRID, GRID)).changes();
  }

  @Test
  void changesAreReadAsTheyWereWritten() throws IOException {
    Path file = folder.resolve("e.csv");
    try (OutputStream stream = Files.newOutputStream(file)) {
      CsvWriter rows = EditsCsv.writer(stream);
      EditsCsv.add(rows, 0, "skin", 7, 5, 3, true);
      EditsCsv.add(rows, 99_999_999_999L, "bone", 0, 0, 0, false);
    }
    assertEquals(
        "frame,body,segment,i,j,k,solid\n0,skin,skin,7,5,3,1\n99999999999,bone,bone,0,0,0,0\n",
        Files.readString(file));
    assertEquals(
        List.of(
            new VoxelChange(0, 1, 7, 5, 3, true),
            new VoxelChange(99_999_999_999L, 0, 0, 0, 0, false)),
        EditsCsv.read(file, SEGMENTS, List.of(GRID, GRID)).changes());
  }

  @Test
  void columnsMayHaveAnyOrderAndRowsComeInThatOfTheirFrames() throws IOException {
    assertEquals(
        List.of(
            new VoxelChange(1, 0, 1, 1, 1, true),
            new VoxelChange(5, 0, 2, 1, 0, false),
            new VoxelChange(5, 0, 3, 1, 0, true)),
        read(
            """
            k,j,i,solid,note,segment,body,frame
            0,1,2,0,a,bone,bone,5
            0,1,3,1,b,bone,bone,5
            1,1,1,1,c,bone,bone,1
            """));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "-1,bone,bone,0,0,0,1|frame is -1|write a whole number from 0 on",
        "1.5,bone,bone,0,0,0,1|frame is 1.5|write a whole number from 0 on",
        "0,bone,bone,8,0,0,1|i is 8|write a whole number from 0 to 7",
        "0,bone,bone,0,6,0,1|j is 6|write a whole number from 0 to 5",
        "0,bone,bone,0,0,4,1|k is 4|write a whole number from 0 to 3",
        "0,bone,bone,0,0,0,2|solid is 2|write a whole number from 0 to 1",
        "0,bone,bone,0,0,0|solid is missing|write a whole number from 0 to 1",
        "0,hair,hair,0,0,0,1|there is no segment hair|list them with palpate info",
        "0,skin,bone,0,0,0,1|the body of segment bone is not skin|name it bone"
      })
  void aRowThatDoesNotFitIsRefusedWithItsLine(String row, String what, String remedy) {
    CsvFormatException refusal =
        assertThrows(
            CsvFormatException.class,
            () -> read("frame,body,segment,i,j,k,solid\n# a remark\n0,bone,bone,7,5,3,1\n" + row));
    assertEquals(
        what + ": " + folder.resolve("e.csv") + " line 4: " + remedy, refusal.getMessage());
  }

  @Test
  void everyColumnIsNeeded() {
    CsvFormatException refusal =
        assertThrows(CsvFormatException.class, () -> read("frame,segment,i,j,k,solid\n"));
    assertEquals(
        "there is no column body: "
            + folder.resolve("e.csv")
            + " line 1: begin with frame,body,segment,i,j,k,solid",
        refusal.getMessage());
  }
}

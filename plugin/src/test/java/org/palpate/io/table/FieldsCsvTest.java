package org.palpate.io.table;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.elastic.RecordedUpdate;
import org.palpate.elastic.RecordedUpdate.Refill;
import org.palpate.elastic.lattice.CellStiffness;
import org.palpate.geometry.Vec3;

class FieldsCsvTest {
  private static final String HEADER = "frame,x,y,z,fx,fy,fz,cells\n";

  @TempDir private Path folder;

  @Test
  void whatIsWrittenIsReadBackBitForBit() throws IOException {
    List<RecordedUpdate> updates =
        List.of(
            update(0, new Vec3(0.1, -2, 1e-300), List.of()),
            update(
                RecordedUpdate.UNUSED,
                new Vec3(1 / 3.0, 2, 3),
                List.of(
                    new Refill(7, new CellStiffness(0.1f, 1 / 3f, 0, 1e-20f, 1)),
                    new Refill(123, new CellStiffness(0, Float.MIN_VALUE, 1, 2, 3)))),
            update(41, new Vec3(4, 5, 6), List.of()),
            update(41, new Vec3(), List.of()));
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    CsvWriter rows = FieldsCsv.writer(bytes);
    for (RecordedUpdate update : updates) {
      FieldsCsv.add(rows, update);
    }
    String text = bytes.toString(StandardCharsets.UTF_8);
    assertTrue(text.startsWith(HEADER), text);
    List<RecordedUpdate> read = read(text);
    assertEquals(updates.size(), read.size());
    for (int n = 0; n < read.size(); n++) {
      assertEquals(updates.get(n).frame(), read.get(n).frame());
      assertTrue(updates.get(n).point().sameBits(read.get(n).point()), "row " + n);
      assertTrue(updates.get(n).forceNewton().sameBits(read.get(n).forceNewton()), "row " + n);
      assertEquals(updates.get(n).refills(), read.get(n).refills());
    }
  }

  private static RecordedUpdate update(long frame, Vec3 at, List<Refill> refills) {
    return new RecordedUpdate(frame, at, new Vec3(0, frame, -0.1), refills);
  }

  @Test
  void columnsAreFoundByTheirNames() throws IOException {
    RecordedUpdate read =
        read("fz,note,cells,z,y,x,fy,fx,frame\n6,any,2:1:2:3:4:5,3,2,1,5,4,9\n").get(0);
    assertEquals(9, read.frame());
    assertTrue(read.point().sameBits(new Vec3(1, 2, 3)));
    assertTrue(read.forceNewton().sameBits(new Vec3(4, 5, 6)));
    assertEquals(List.of(new Refill(2, new CellStiffness(1, 2, 3, 4, 5))), read.refills());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "x,1,2,3,4,5,6,           | frame is x",
        ",1,2,3,4,5,6,            | frame is missing",
        "-2,1,2,3,4,5,6,          | frame is -2",
        "4,1,2,3,4,5,6,           | frame is 4",
        "5,1,NaN,3,4,5,6,         | y is NaN",
        "5,1,2,3,4,5,Infinity,    | fz is Infinity",
        "5,1,2,3,4,5,6,7:1:2:3:4  | a cell is 7:1:2:3:4",
        "5,1,2,3,4,5,6,a:1:2:3:4:5 | a cell is a:1:2:3:4:5",
        "5,1,2,3,4,5,6,7:1:2:3:-4:5 | a number of a cell is negative",
        "5,1,2,3,4,5,6,7:1:0:3:4:5 | a cell has no modulus"
      })
  void aRowThatIsNotUnderstoodIsRefusedWithItsLine(String row, String says) {
    String text = HEADER + "5,1,2,3,4,5,6,\n" + row + "\n";
    String message = assertThrows(CsvFormatException.class, () -> read(text)).getMessage();
    assertTrue(message.startsWith(says), message);
    assertTrue(message.contains(folder.resolve("fields.csv") + " line 3: "), message);
  }

  @Test
  void aTableWithoutAColumnIsRefusedByItsName() {
    String text = "frame,x,y,z,fx,fy,fz\n1,1,2,3,4,5,6\n";
    String message = assertThrows(CsvFormatException.class, () -> read(text)).getMessage();
    assertTrue(message.startsWith("there is no column cells: "), message);
  }

  private List<RecordedUpdate> read(String text) throws IOException {
    return FieldsCsv.read(Files.writeString(folder.resolve("fields.csv"), text));
  }
}

package org.palpate.io.table;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;

class TableWritersTest {
  private static final Vec3 A = new Vec3(1, 2, 3);
  private static final Vec3 B = new Vec3(-0.5, 1e-7, 1e20);
  private static final Vec3 C = new Vec3(0.1, -0.0, 7);

  private interface Rows {
    void writeTo(OutputStream stream) throws IOException;
  }

  private static String written(Rows rows) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    rows.writeTo(bytes);
    return bytes.toString(StandardCharsets.UTF_8);
  }

  @Test
  void aRowOfAFrameHasDevicePointForceContactAndPath() throws IOException {
    assertEquals(
        """
        frame,t_ms,dx,dy,dz,px,py,pz,fx,fy,fz,contact,path
        5,2.5,1.0,2.0,3.0,-0.5,1.0E-7,1.0E20,0.1,-0.0,7.0,1,0.25
        6,3.0,-0.5,1.0E-7,1.0E20,1.0,2.0,3.0,1.0,2.0,3.0,0,0.0
        """,
        written(
            stream -> {
              FramesCsvWriter frames = new FramesCsvWriter(stream);
              frames.add(5, 2.5, A, B, C, true, 0.25);
              frames.add(6, 3, B, A, A, false, 0);
            }));
  }

  @Test
  void aRowOfAToolHasBothOrientationsAndTheTorqueBehind() throws IOException {
    Pose device = new Pose();
    device.translation.set(A);
    device.rotation.set(0.5, -0.5, 0.5, 0.5);
    Pose tool = new Pose();
    tool.translation.set(B);
    tool.rotation.set(0, 0, 0, -1);
    assertEquals(
        """
        frame,t_ms,dx,dy,dz,px,py,pz,fx,fy,fz,contact,path,dqw,dqx,dqy,dqz,pqw,pqx,pqy,pqz,tx,ty,tz
        0,1.0,1.0,2.0,3.0,-0.5,1.0E-7,1.0E20,0.1,-0.0,7.0,0,9.0,0.5,-0.5,0.5,0.5,0.0,0.0,0.0,-1.0,\
        1.0,2.0,3.0
        """,
        written(stream -> new ToolFramesCsvWriter(stream).add(0, 1, device, tool, C, A, false, 9)));
  }

  @Test
  void legsAreWrittenFromStartToEnd() throws IOException {
    assertEquals(
        """
        frame,leg,x0,y0,z0,x1,y1,z1
        7,-1,1.0,2.0,3.0,1.0,2.0,3.0
        7,0,1.0,2.0,3.0,4.0,5.0,6.0
        """,
        written(
            stream -> {
              LegsCsvWriter legs = new LegsCsvWriter(stream);
              legs.addRelease(7, A);
              legs.add(7, 0, 1, 2, 3, 4, 5, 6);
            }));
    assertEquals(
        """
        frame,leg,body,point,x0,y0,z0,x1,y1,z1
        7,0,2,31,1.0,2.0,3.0,0.1,-0.0,7.0
        """,
        written(stream -> new ToolLegsCsvWriter(stream).add(7, 0, 2, 31, A, C)));
  }

  @ParameterizedTest
  @ValueSource(strings = {"a,b", "say \"no\"", "two\nlines", "two\rlines"})
  void aCellThatWouldBreakItsRowIsQuoted(String text) throws IOException {
    String row = written(stream -> new CsvWriter(stream, "n,t").cell(1).cell(text).cell(0.5).end());
    assertEquals("n,t\n1,\"" + text.replace("\"", "\"\"") + "\",0.5\n", row);
  }

  @Test
  void aReportIsIndentedAndKeepsTheOrderOfItsFields() throws IOException {
    Map<String, Object> inner = new LinkedHashMap<>();
    inner.put("z", 1L);
    inner.put("a", -2);
    Map<String, Object> report = new LinkedHashMap<>();
    report.put("name", "say \"no\" \u00e9\n");
    report.put("number", 0.1 + 0.2);
    report.put("large", 1e22);
    report.put("none", null);
    report.put("nan", Double.NaN);
    report.put("infinite", Double.NEGATIVE_INFINITY);
    report.put("flag", true);
    report.put("list", List.of(1, 2.5, "x", List.of(false)));
    report.put("map", inner);
    report.put("empty", Map.of());
    assertEquals(
        """
        {
          "name" : "say \\"no\\" \u00e9\\n",
          "number" : 0.30000000000000004,
          "large" : 1.0E22,
          "none" : null,
          "nan" : null,
          "infinite" : null,
          "flag" : true,
          "list" : [ 1, 2.5, "x", [ false ] ],
          "map" : {
            "z" : 1,
            "a" : -2
          },
          "empty" : { }
        }
        """,
        written(stream -> ReportJson.write(report, stream)));
  }

  @Test
  void aReportLeavesItsStreamOpen() throws IOException {
    assertEquals(
        "{ }\n{ }\n",
        written(
            stream -> {
              ReportJson.write(Map.of(), stream);
              ReportJson.write(Map.of(), stream);
            }));
  }
}

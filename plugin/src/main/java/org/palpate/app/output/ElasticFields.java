package org.palpate.app.output;

import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import org.palpate.elastic.ElasticBody;
import org.palpate.elastic.UpdateCounters;
import org.palpate.io.file.CountText;

/** The fields of a report that state elastic segments. */
public final class ElasticFields {
  private ElasticFields() {}

  /** Returns the fields in the order of the report, after the last frame. */
  public static Map<String, Object> of(ElasticBody body) {
    UpdateCounters counts = body.counters();
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("hexes", body.hexahedra());
    fields.put("untouchable_voxels", body.untouchableVoxels());
    fields.put("updates", counts.updates());
    fields.put("skipped", counts.skipped());
    fields.put("update_ms", times(counts));
    fields.put("scaled_back", counts.scaledBack());
    fields.put("refused", counts.refused());
    fields.put("windowless", counts.windowless());
    fields.put("worst_residual", counts.worstResidual());
    fields.put("clipped_frames", body.contact().clippedFrames());
    fields.put("lowered_frames", body.contact().loweredFrames());
    fields.put("elsewhere", counts.elsewhere());
    fields.put("free_parts", body.freeParts());
    return fields;
  }

  /** Returns how long updates of the elastic segments took, as a line. */
  public static String line(UpdateCounters counts) {
    return String.format(
        Locale.ROOT,
        "%s of elastic segments, %.1f ms, 99 %% under %.1f ms, at most %.1f ms",
        CountText.of(counts.updates(), "update"),
        counts.updateMs(50),
        counts.updateMs(99),
        counts.updateMs(100));
  }

  private static Map<String, Object> times(UpdateCounters counts) {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("p50", counts.updateMs(50));
    fields.put("p99", counts.updateMs(99));
    fields.put("max", counts.updateMs(100));
    return fields;
  }
}

package org.palpate.benchmarks.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Function;

/** The tables that {@code bench} writes, with their columns. */
public enum StudyTable {
  /** Times of all benchmarks. */
  SPEED("speed.csv", Columns.TIMES),
  /** Times of the paper's Table 1. */
  TABLE1("table1.csv", Columns.TIMES),
  /** Times with and without each skip. */
  SKIPS("skips.csv", Columns.TIMES),
  /** Times in grids of growing size. */
  SCALE("scale.csv", Columns.TIMES),
  /** Errors of forces on analytic surfaces. */
  ACCURACY(
      "accuracy.csv",
      "shape,edge_mm,spacing_mm,depth_voxels,speed_voxels,solver,angle_rms_deg,angle_worst_deg,"
          + "height_mean_mm,height_std_mm,lag,force_change,lost_frames,ns_per_frame"),
  /** Distances beyond the nearest free point. */
  NEAREST(
      "nearest.csv", "shape,depth_voxels,solver,mean_excess_voxels,worst_excess_voxels,presses"),
  /** Figures of rigid tools. */
  RIGID("rigid.csv", Columns.FIGURES),
  /** Figures of tools that cut. */
  CARVE("carve.csv", Columns.FIGURES),
  /** Figures of elastic segments. */
  ELASTIC("elastic.csv", Columns.FIGURES),
  /** Figures of broken bones that a simulated hand puts together. */
  FRACTURE("fracture.csv", Columns.FIGURES),
  /** Frames of sessions in which the hand holds a fragment. */
  HOLD("hold.csv", Columns.FIGURES),
  /** Times of judging legs by device and number. */
  GPU("gpu.csv", "device,points,part,frames,least_us,p50_us,p99_us,p99_9_us,max_us"),
  /** Launches of a device that sliding tools need. */
  GPU_LAUNCHES(
      "gpu-launches.csv",
      "condition,points,motions,legs_p50,legs_p99,legs_most,launches_alone,launches_together,"
          + "launches_from_100,launches_from_1000,launches_from_10000"),
  /** Times of whole frames with an OpenCL device and without. */
  GPU_FRAMES(
      "gpu-frames.csv",
      "device,condition,points,cpu_p50_us,cpu_p99_9_us,device_p50_us,device_p99_9_us,launches"),
  /** Largest stable stiffness of the model and of the theory. */
  STABILITY_THEORY(
      "stability-theory.csv",
      "rate_hz,delay_samples,damping_ns_per_m,largest_n_per_m,passive_n_per_m"),
  /** Stability by device. */
  STABILITY_DEVICES("stability-devices.csv", Columns.STABILITY),
  /** Stability by shape and solver. */
  STABILITY_SHAPES("stability-shapes.csv", Columns.STABILITY),
  /** Stability of rigid tools by device and length. */
  STABILITY_TOOLS(
      "stability-tools.csv",
      "device,grip,held,rod_mm,rms_radius_mm,rate_hz,delay_samples,handle_kg,damping_ns_per_m,"
          + Columns.MARGIN
          + ",given_mj,verdict"),
  /** Stability with guides, effects and mass. */
  STABILITY_FEEL(
      "stability-feel.csv",
      "device,grip,feel,rate_hz,delay_samples,handle_kg,damping_ns_per_m,"
          + Columns.MARGIN
          + ",given_mj,verdict"),
  /** Stability of a burr that cuts. */
  STABILITY_CARVE(
      "stability-carve.csv",
      "device,grip,rate_mm3_per_ns,rate_hz,delay_samples,handle_kg,damping_ns_per_m,"
          + "stiffness_n_per_m,over_default,verdict,back_mm,energy_back_mj,rise_n_per_ms,cut_mm3"),
  /** Cost of a frame by the method that changes the scene. */
  SYNC(
      "sync.csv",
      "way,round,rate_hz,work_p50_us,work_p99_us,work_p99_9_us,work_max_us,period_p50_us,"
          + "period_p99_us,period_p99_9_us,period_max_us,redraws"),
  /** Cost of publishing the properties of a frame. */
  SYNC_WRITES("sync-writes.csv", "way,changed_ns,unchanged_ns,p99_9_ns,max_ns"),
  /** Extraction of surfaces. */
  SURFACES(
      "surfaces.csv",
      "data,voxels,triangles,vertices,cpu_s,heap_bytes,card_bytes,coarse_triangles,"
          + "coarse_cpu_s,brick_median_ms,brick_most_ms"),
  /** Work of frames; solver and seed are part of the name of its file. */
  STEPS("steps-SOLVER-SEED.csv", "hand,frames,median_steps,p99_steps,worst_steps");

  private final String fileName;
  private final String header;

  StudyTable(String fileName, String header) {
    this.fileName = fileName;
    this.header = header;
  }

  /** Returns the name of the file. */
  public String fileName() {
    return fileName;
  }

  /** Returns the names of the columns in order. */
  public List<String> columns() {
    return List.of(header.split(","));
  }

  /** Writes the table into a folder; see {@link TableFile#write}. */
  public <R> void write(Path folder, List<R> results, Function<R, List<Object>> cells)
      throws IOException {
    TableFile.write(folder.resolve(fileName), columns(), results, cells);
  }

  /** Columns of several tables. */
  private static final class Columns {
    static final String FIGURES = "study,condition,figure,value,unit,target,verdict";
    static final String TIMES =
        "group,benchmark,condition,unit,median,least,greatest,iterations,bytes_per_op";
    static final String MARGIN =
        "default_n_per_m,largest_n_per_m,margin,play_mm,energy_back_mj,rise_n_per_ms";
    static final String STABILITY =
        "device,grip,shape,solver,rate_hz,delay_samples,handle_kg,damping_ns_per_m,"
            + Columns.MARGIN;
  }
}

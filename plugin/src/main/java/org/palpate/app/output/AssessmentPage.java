package org.palpate.app.output;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.palpate.assess.ContactStatistics;
import org.palpate.assess.SessionAssessor;
import org.palpate.assess.SessionCourse;
import org.palpate.assess.TremorSpectrum;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberText;

/**
 * The page of an assessment: one file of HTML with its style and its plots, which refers to nothing
 * outside. One thread.
 */
final class AssessmentPage {
  private static final int WIDTH = 860;
  private static final int HEIGHT = 240;
  private static final int SQUARE = 280;
  private static final String AXES = "xyz";

  /** A hand at rest has no motion, which a logarithmic axis cannot show. */
  private static final double LEAST_DENSITY = 1e-12;

  /** The part of the spectrum that is shown, relative to its highest value. */
  private static final double DECADES = 1e-9;

  private static final String HEAD =
      """
      <!DOCTYPE html>
      <html lang="en">
      <head>
      <meta charset="utf-8">
      <title>Assessment of a session</title>
      <style>
      body { font: 15px/1.45 sans-serif; color: #1c2733; background: #fff; max-width: 900px;
        margin: 24px auto; padding: 0 16px; }
      h1 { font-size: 24px; } h2 { font-size: 18px; margin-top: 32px; }
      table { border-collapse: collapse; } td, th { padding: 3px 14px 3px 0; text-align: right; }
      th { border-bottom: 1px solid #9aa7b3; font-weight: 600; }
      td:first-child, th:first-child { text-align: left; }
      svg { font: 11px sans-serif; fill: #4a5764; } .grid { stroke: #e3e8ec; }
      .most, .mean, .path { fill: none; stroke-width: 1.5; } .most { stroke: #1f6fb2; }
      .mean { stroke: #7fb3dc; } .path { stroke: #1f6fb2; stroke-width: 1; }
      .forbidden { fill: #d64541; fill-opacity: .3; } .band { fill: #f2c14e; fill-opacity: .25; }
      .hold { fill: #1f6fb2; fill-opacity: .5; } .name { fill: #1c2733; }
      .bad { color: #b3261e; font-weight: 600; } .note { color: #5d6b78; }
      </style>
      </head>
      <body>
      <h1>Assessment of a session</h1>
      """;

  /** The units of a report by the end of its keys. */
  private static final Map<String, String> UNITS = Map.of("mm", "mm", "s", "s", "deg", "degrees");

  /** The keys of a report that hold a volume for each segment. */
  private static final List<String> VOLUMES = List.of("carved", "added");

  private final SessionAssessor assessor;
  private final AssessmentValues values;
  private final UnaryOperator<Vec3> world;
  private final List<String> aboutForce = new ArrayList<>();
  private final StringBuilder page = new StringBuilder(HEAD);

  /**
   * Prepares the page of a session that has ended.
   *
   * @param world changes a position of the course into world mm, in place
   */
  AssessmentPage(SessionAssessor assessor, AssessmentValues values, UnaryOperator<Vec3> world) {
    this.assessor = assessor;
    this.values = values;
    this.world = world;
  }

  /** Adds a sentence below the plot of the force. */
  void noteAboutForce(String sentence) {
    aboutForce.add(sentence);
  }

  /** Returns the page. */
  String text() {
    addSummary();
    addForce();
    addSegments();
    addPath();
    addTremor();
    addHolds();
    addOutcome();
    return page.append("</body>\n</html>\n").toString();
  }

  private void heading(String title) {
    page.append("<h2>").append(title).append("</h2>\n");
  }

  private void note(String sentence) {
    page.append("<p class=\"note\">").append(SvgPlot.escaped(sentence)).append("</p>\n");
  }

  private void addSummary() {
    ContactStatistics contacts = assessor.contacts();
    page.append("<table>\n");
    row("Time", number(assessor.seconds(), 2) + " s");
    row("In contact", number(contacts.seconds(), 2) + " s, " + contacts.contacts() + " times");
    row("Path of the hand", number(assessor.handPathMm(), 1) + " mm");
    row("Path of the tool", number(assessor.toolPathMm(), 1) + " mm");
    row("Mean force in contact", number(contacts.meanNewton(), 3) + " N");
    row(
        "Largest force",
        number(contacts.largestNewton(), 3)
            + " N at "
            + number(contacts.largestAtSeconds(), 2)
            + " s");
    row("Set free", assessor.freed() + " times");
    page.append("</table>\n");
    if ((long) values.fields().get("lost_frames") > 0) {
      note(values.fields().get("lost_frames") + " frames were lost; all figures lack them.");
    }
  }

  private void row(String name, String value) {
    cells("td", List.of(name, value));
  }

  /** Adds a row whose cells are texts, not markup. */
  private void cells(String tag, Collection<String> texts) {
    page.append("<tr>");
    for (String text : texts) {
      String safe = SvgPlot.escaped(text);
      page.append('<').append(tag).append('>').append(safe).append("</").append(tag).append('>');
    }
    page.append("</tr>\n");
  }

  private void addForce() {
    heading("Force of contact");
    SessionCourse course = assessor.course();
    double[] seconds = new double[course.rows()];
    double[] largest = new double[seconds.length];
    double[] mean = new double[seconds.length];
    double most = 0;
    for (int n = 0; n < seconds.length; n++) {
      seconds[n] = course.hasFrames(n) ? course.seconds(n) : Double.NaN;
      largest[n] = course.largestNewton(n);
      mean[n] = course.meanNewton(n);
      most = Math.max(most, largest[n]);
    }
    PlotAxis force = PlotAxis.fromZero("N", 1.05 * most);
    SvgPlot plot = new SvgPlot(WIDTH, HEIGHT, time(), force);
    addForbidden(course, plot, force.high());
    plot.line("most", seconds, largest);
    plot.line("mean", seconds, mean);
    page.append(plot.svg("Force over time"));
    note("Dark: largest force of each interval; light: its mean. Red: a protected segment.");
    aboutForce.forEach(this::note);
  }

  private PlotAxis time() {
    return PlotAxis.fromZero("s", assessor.seconds());
  }

  private static void addForbidden(SessionCourse course, SvgPlot plot, double top) {
    double half = course.rows() > 1 ? (course.seconds(1) - course.seconds(0)) / 2 : 0;
    int from = -1;
    for (int row = 0; row <= course.rows(); row++) {
      boolean touches = row < course.rows() && course.hasFrames(row) && course.forbidden(row) > 0;
      if (touches && from < 0) {
        from = row;
      } else if (!touches && from >= 0) {
        double begin = course.seconds(from) - half;
        double end = course.seconds(row - 1) + half;
        plot.rectangle("forbidden", begin, 0, end, top, number(begin, 2) + " s");
        from = -1;
      }
    }
  }

  private void addSegments() {
    heading("Segments");
    page.append("<table>\n");
    cells("th", List.of("segment", "contacts", "s", "mean N", "largest N", "at s", ""));
    for (Map<String, Object> segment : values.segments().rows()) {
      boolean isProtected = segment.get("protected").equals(1L);
      cells(
          "td",
          List.of(
              segment.get("segment").toString(),
              segment.get("contacts").toString(),
              number((double) segment.get("seconds"), 2),
              number((double) segment.get("mean_force_n"), 3),
              number((double) segment.get("max_force_n"), 3),
              number((double) segment.get("max_force_s"), 2),
              isProtected ? "protected" : ""));
    }
    page.append("</table>\n");
    for (Map<String, Object> segment : values.segments().rows()) {
      if (segment.get("protected").equals(1L) && (long) segment.get("contacts") > 0) {
        page.append("<p class=\"bad\">Forbidden contact: ")
            .append(SvgPlot.escaped(segment.get("segment").toString()))
            .append("</p>\n");
      }
    }
  }

  private void addPath() {
    heading("Path of the tool");
    double[][] axes = positions();
    double halfMm = 0.5;
    for (double[] axis : axes) {
      halfMm = Math.max(halfMm, 0.55 * (most(axis) - least(axis)));
    }
    addProjection(axes, 0, 1, halfMm);
    addProjection(axes, 0, 2, halfMm);
    addProjection(axes, 1, 2, halfMm);
    note("World millimetres, along pairs of axes at one scale.");
  }

  /** Returns the positions of the rows along each axis, world mm; NaN for a row without frames. */
  private double[][] positions() {
    SessionCourse course = assessor.course();
    double[][] axes = new double[3][course.rows()];
    Vec3 position = new Vec3();
    for (int row = 0; row < course.rows(); row++) {
      Vec3 at = world.apply(course.positionMm(row, position));
      for (int axis = 0; axis < 3; axis++) {
        axes[axis][row] = course.hasFrames(row) ? at.get(axis) : Double.NaN;
      }
    }
    return axes;
  }

  private static double least(double[] values) {
    return Arrays.stream(values).filter(Double::isFinite).min().orElse(0);
  }

  private static double most(double[] values) {
    return Arrays.stream(values).filter(Double::isFinite).max().orElse(0);
  }

  private void addProjection(double[][] axes, int across, int up, double halfMm) {
    SvgPlot plot =
        new SvgPlot(SQUARE, SQUARE, axis(axes[across], across, halfMm), axis(axes[up], up, halfMm));
    plot.line("path", axes[across], axes[up]);
    page.append(plot.svg("Path along " + AXES.charAt(across) + " and " + AXES.charAt(up)));
  }

  private static PlotAxis axis(double[] values, int axis, double halfMm) {
    double middle = (least(values) + most(values)) / 2;
    return new PlotAxis(AXES.charAt(axis) + ", mm", middle - halfMm, middle + halfMm, false);
  }

  private void addTremor() {
    heading("Tremor of the hand");
    TremorSpectrum tremor = assessor.tremor();
    if (tremor.lines() == 0) {
      note("The session is too short for a spectrum, which takes five seconds.");
      return;
    }
    double[] hertz = new double[tremor.lines()];
    double[] density = new double[hertz.length];
    for (int n = 0; n < hertz.length; n++) {
      hertz[n] = tremor.hertz(n + 1);
      density[n] = Math.max(LEAST_DENSITY, tremor.density(n + 1));
    }
    double high = 2 * most(density);
    PlotAxis powers = new PlotAxis("mm²/Hz", Math.max(least(density), high * DECADES), high, true);
    PlotAxis across = PlotAxis.fromZero("Hz", hertz[hertz.length - 1]);
    SvgPlot plot = new SvgPlot(WIDTH, HEIGHT, across, powers);
    plot.rectangle(
        "band",
        TremorSpectrum.LOW_HERTZ,
        powers.low(),
        TremorSpectrum.HIGH_HERTZ,
        powers.high(),
        "band of tremor");
    plot.line("most", hertz, density);
    page.append(plot.svg("Spectrum of the motion of the hand"));
    String peak = tremor.peakHertz().isEmpty() ? "" : peak(tremor.peakHertz().getAsDouble());
    note(
        "From 4 to 12 Hz the hand moved by "
            + number(tremor.rmsMm().orElse(0), 3)
            + " mm (root mean square)"
            + peak
            + ".");
  }

  private static String peak(double hertz) {
    return ", most at " + number(hertz, 1) + " Hz";
  }

  private void addHolds() {
    List<Map<String, Object>> holds = values.holds().rows();
    if (holds.isEmpty()) {
      return;
    }
    heading("What the hand held");
    List<Object> bodies = holds.stream().map(hold -> hold.get("body")).distinct().toList();
    PlotAxis rows = PlotAxis.fromZero("", bodies.size());
    SvgPlot plot = new SvgPlot(WIDTH, 60 + 28 * bodies.size(), time(), rows);
    page.append("<table>\n");
    cells("th", List.of("body", "from s", "to s", "moved mm", "turned degrees"));
    for (Map<String, Object> hold : holds) {
      double from = (double) hold.get("from_s");
      double to = (double) hold.get("to_s");
      String name = hold.get("body").toString();
      int row = bodies.indexOf(hold.get("body"));
      plot.rectangle("hold", from, row + 0.2, to, row + 0.8, name);
      plot.text(from, row + 0.5, name);
      cells(
          "td",
          List.of(
              name,
              number(from, 2),
              number(to, 2),
              number((double) hold.get("moved_mm"), 2),
              number((double) hold.get("turned_deg"), 2)));
    }
    page.append("</table>\n").append(plot.svg("What the hand held over time"));
  }

  /** Adds what the session's report says about segments and placements, as a table of its keys. */
  private void addOutcome() {
    List<String> keys = AssessmentValues.OF_REPORT.stream().filter(this::isReported).toList();
    if (keys.isEmpty()) {
      return;
    }
    heading("Outcome");
    page.append("<table>\n");
    keys.forEach(key -> addOutcome(key, values.fields().get(key)));
    page.append("</table>\n");
  }

  private boolean isReported(String key) {
    return values.fields().containsKey(key);
  }

  private void addOutcome(String name, Object value) {
    if (value instanceof Map<?, ?> map) {
      map.forEach((key, inner) -> addOutcome(name + " " + words(name, key.toString()), inner));
    } else if (value instanceof List<?> list && list.stream().allMatch(Map.class::isInstance)) {
      list.forEach(inner -> addOutcome(name, inner));
    } else {
      row(name, value instanceof Double number ? NumberText.thousandths(number) : value.toString());
    }
  }

  /** Returns a key of a report as words with the unit at the end, as in {@code nearest, mm}. */
  private static String words(String parent, String key) {
    if (VOLUMES.contains(parent)) {
      return key + ", mm³"; // The key is the name of a segment.
    }
    int end = key.lastIndexOf('_');
    String unit = end < 0 ? null : UNITS.get(key.substring(end + 1));
    return unit == null ? key.replace('_', ' ') : key.substring(0, end) + ", " + unit;
  }

  private static String number(double value, int decimals) {
    return String.format(Locale.ROOT, "%." + decimals + "f", value);
  }
}

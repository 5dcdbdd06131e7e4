package org.palpate.documents;

import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.util.DocTrees;
import com.sun.source.util.JavacTask;
import java.io.IOException;
import java.net.URI;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;

/**
 * Sources as the compiler parses them.
 *
 * @param units the parsed files, in the order of their classes
 * @param comments finds the Javadoc of a declaration
 */
record SourceTrees(List<CompilationUnitTree> units, DocTrees comments) {
  /** Parses classes, each given by its full name and its text. */
  static SourceTrees of(Map<String, String> classes) throws IOException {
    List<JavaFileObject> files = new ArrayList<>();
    classes.forEach((name, text) -> files.add(new SourceText(name, text)));
    JavacTask task =
        (JavacTask)
            ToolProvider.getSystemJavaCompiler()
                .getTask(null, null, null, List.of("-proc:none"), null, files);
    List<CompilationUnitTree> units = new ArrayList<>();
    task.parse().forEach(units::add);
    return new SourceTrees(units, DocTrees.instance(task));
  }

  /** The text of a class as the compiler reads it. */
  private static final class SourceText extends SimpleJavaFileObject {
    private final String text;

    SourceText(String name, String text) {
      super(URI.create("string:///" + name.replace('.', '/') + ".java"), Kind.SOURCE);
      this.text = text;
    }

    @Override
    public CharSequence getCharContent(boolean ignoreEncodingErrors) {
      return text;
    }
  }
}

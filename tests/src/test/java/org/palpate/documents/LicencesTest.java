package org.palpate.documents;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.xpath.XPath;
import javax.xml.xpath.XPathConstants;
import javax.xml.xpath.XPathFactory;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.w3c.dom.Document;
import org.w3c.dom.NodeList;

/**
 * The page of licences names every library that a module uses outside its tests, and so does the
 * list of parts that the plug-in's jars take if Maven is offline.
 */
class LicencesTest {
  private static final Path PAGE = Path.of("docs/licences.md");
  private static final Path PARTS = Path.of("plugin/src/main/sbom/parts.cdx.json");
  private static final String LIBRARIES =
      "/project/dependencies/dependency[groupId!='org.palpate' and not(scope='test')]/artifactId";

  @ParameterizedTest
  @ValueSource(strings = {"core", "native", "plugin", "benchmarks"})
  void everyLibraryHasALicence(String module) throws Exception {
    String page = Files.readString(Sources.root().resolve(PAGE));
    Set<String> libraries = libraries(Sources.root().resolve(module).resolve("pom.xml").toFile());
    assertTrue(!libraries.isEmpty(), "there are some");
    libraries.removeIf(name -> Pattern.compile("[ `]" + name + "[ `]").matcher(page).find());
    assertTrue(libraries.isEmpty(), () -> libraries + " of " + module + " are not in " + PAGE);
  }

  @ParameterizedTest
  @ValueSource(strings = {"core", "native", "plugin"})
  void theListOfPartsHasTheVersionAndEveryLibrary(String module) throws Exception {
    String parts = Files.readString(Sources.root().resolve(PARTS));
    File pom = Sources.root().resolve(module).resolve("pom.xml").toFile();
    String version = texts(pom, "/project/parent/version").iterator().next();
    String self = "pkg:maven/org.palpate/palpate-" + module + "@" + version + "?";
    assertTrue(parts.contains(self), () -> self + " is not in " + PARTS);
    for (String library : libraries(pom)) {
      assertTrue(parts.contains("/" + library + "@"), () -> library + " is not in " + PARTS);
    }
  }

  private static Set<String> libraries(File pom) throws Exception {
    return texts(pom, LIBRARIES);
  }

  /** Returns the texts of the elements that a path finds in a file. */
  private static Set<String> texts(File file, String path) throws Exception {
    Document document = DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(file);
    XPath xpath = XPathFactory.newInstance().newXPath();
    NodeList nodes = (NodeList) xpath.evaluate(path, document, XPathConstants.NODESET);
    Set<String> found = new TreeSet<>();
    for (int n = 0; n < nodes.getLength(); n++) {
      found.add(nodes.item(n).getTextContent());
    }
    return found;
  }
}

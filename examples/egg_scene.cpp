#include <LosTopos/shapes/solids.h>

#include "models.h"

// A bubble that starts as an egg: a sphere, of which the half on the side of +x is stretched.
foamsim::SceneEntry egg_scene() {
  foamsim::SceneEntry scene;
  scene.name = "egg";
  scene.summary = "one bubble that starts as an egg";
  scene.options = {base::whole_number("n", 2, 0, "subdivisions of an icosahedron (20*4^n triangles)"),
                   base::positive_number("stretch", 1.4, "length of the pointed half over the radius")};
  scene.defaults = {{"topology.enabled", false}};
  scene.build = [](const base::OptionSet& options) {
    lostopos::SurfaceMesh mesh = lostopos::icosphere(options.whole("n"));
    for (lostopos::Vertex v : mesh.vertices()) {
      lostopos::Vec3 x = mesh.position(v);
      if (x.x() > 0) x.x() *= options.number("stretch");
      mesh.set_position(v, x);
    }
    return mesh;
  };
  return scene;
}

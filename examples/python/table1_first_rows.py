"""The first rows of table 1 (docs/accuracy.md): how far the films' angles at the border are from 120 degrees at rest."""

import foamsim

effects = foamsim.Catalogue().options("doublebubble")["effects"][0] + ["damping"]
for area, own in (("averaged", {}), ("constant-edge", {"phi": 0.75})):
    film = foamsim.Simulation("doublebubble", {"remeshing.smoothing": False, **own}, n=16, area=area, dt=0.01, diffusion=10,
                              effects=effects, damping=0.02, damping_from=4)
    film.run(time=12, callback=lambda sim: not sim.at_rest)
    row = film.metrics()
    print(f"{area:14} {row['triangles']:5} {row['angle_rms_deg']:6.2f} degrees at time {film.time:.2f}")

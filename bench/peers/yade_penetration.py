# A steel ball thrown into a bed of spheres under YADE: yade -n -x -j1 yade_penetration.py CASE PATH. CASE is the JSON
# that penetration.py writes, PATH the table of times and heights that it reads. Constants are those of the case; the
# ball is a sphere that may turn, and touches the floor.
import json
import math
import resource
import sys

with open(sys.argv[1]) as file:
    case = json.load(file)
glass = O.materials.append(
    FrictMat(young=case["glass"]["E"], poisson=0.2, density=case["glass"]["density"], frictionAngle=math.atan(0.3))
)
steel = O.materials.append(FrictMat(young=210e9, poisson=0.2, density=7200, frictionAngle=math.atan(0.2)))
for x, y, z, r in case["bed"]:
    O.bodies.append(sphere((x, y, z), r, material=glass))
for axis, (low, high) in enumerate(case["box"]):
    O.bodies.append(wall(low, axis=axis, sense=1, material=steel))
    O.bodies.append(wall(high, axis=axis, sense=-1, material=steel))
ball = O.bodies[O.bodies.append(sphere(case["ball"]["place"], case["ball"]["radius"], material=steel))]
ball.state.vel = (0, -case["ball"]["speed"], 0)
restitution = [(glass, glass, case["restitution"])]
restitution += [(steel, glass, case["restitution_of_steel"]), (steel, steel, case["restitution_of_steel"])]
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()], verletDist=3e-4),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom(hertzian=True)],
        [Ip2_FrictMat_FrictMat_MindlinPhys(en=MatchMaker(matches=restitution))],
        [Law2_ScGeom_MindlinPhys_Mindlin()],
    ),
    NewtonIntegrator(damping=0, gravity=(0, -9.81, 0)),
]
O.dt = case["time_step"]
every = max(1, round(case["every"] / O.dt))
start = resource.getrusage(resource.RUSAGE_SELF).ru_utime
with open(sys.argv[2], "w") as table:
    table.write("time,height\n0,%.9g\n" % ball.state.pos[1])
    while O.time < case["duration"] - 0.5 * case["every"]:
        O.run(every, True)
        table.write("%.9g,%.9g\n" % (O.time, ball.state.pos[1]))
        table.flush()
print("CPU_SECONDS", resource.getrusage(resource.RUSAGE_SELF).ru_utime - start)

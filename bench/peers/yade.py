# The benchmark's packing between four walls under YADE: yade -n -x -j1 yade.py TABLE STEPS. Prints CPU seconds of STEPS
# steps.
import math
import resource
import sys

table, steps = sys.argv[1], int(sys.argv[2])
lines = [[float(v) for v in line.split(",")] for line in open(table)]
left, right, bottom, top = lines[0]
grain = O.materials.append(FrictMat(young=1e9, poisson=0.3, frictionAngle=math.atan(0.3), density=1000))
for x, y, r in lines[1:]:
    body = sphere((x, y, 0), r, material=grain)
    body.state.blockedDOFs = "zXY"
    O.bodies.append(body)
for place, axis, sense in ((left, 0, 1), (right, 0, -1), (bottom, 1, 1), (top, 1, -1)):
    O.bodies.append(wall(place, axis=axis, sense=sense, material=grain))
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()], verletDist=4e-4),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()],
        [Ip2_FrictMat_FrictMat_FrictPhys()],
        [Law2_ScGeom_FrictPhys_CundallStrack()],
    ),
    NewtonIntegrator(damping=0.2),
]
O.dt = 0.1 * PWaveTimeStep()
O.run(50, True)
start = resource.getrusage(resource.RUSAGE_SELF).ru_utime
O.run(steps, True)
print("CPU_SECONDS", resource.getrusage(resource.RUSAGE_SELF).ru_utime - start)

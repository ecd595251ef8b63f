(run with: --machine arm4 --machine-set kinematics.forearm=100)
O0001 (T1 ends at 163.835, which is 45.5 mm from the shoulder)
G01 X150. Y50. F600.
X60. (expect moves: line X60 Y50)
X-60. (expect moves: line X-60 Y50)
M30
(finally machine X-60 Y50)

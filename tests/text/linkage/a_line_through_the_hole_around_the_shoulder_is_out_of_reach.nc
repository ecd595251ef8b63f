(run with: --machine arm4 --machine-set kinematics.forearm=100)
O0001 (links of 132 and 100: both ends are within reach, the way between them is not)
G01 X150. Y50. F600. (expect moves: line X150 Y50)
X60. Y20. (expect moves: line X60 Y20)
X-60. (expect alarm OUT_OF_REACH says reaches from 32 to 232 mm)
M30
(finally machine X60 Y20)

(run with: --machine arm4)
O0001 (no elbow holds a tip beyond 264 mm; what was commanded before is made)
G01 X200. Y100. F600. (expect moves: line X200 Y100)
#100=1
G01 X260. Y60. Z-5. (expect alarm OUT_OF_REACH says the arm reaches from 0 to 264 mm) (expect moves: none)
#100=2
M30
(finally #100=1)
(finally machine X200 Y100 Z0)

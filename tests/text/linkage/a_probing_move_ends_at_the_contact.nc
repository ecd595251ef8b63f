(run with: --machine arm4 --skip-at X=220)
O0001 (and the next move begins there)
G01 X200. Y50. F600.
G31 X250. F100. (expect moves: probe X220 Y50)
G01 X180. F600. (expect moves: line X180 Y50)
M30
(finally machine X180 Y50)

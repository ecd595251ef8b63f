(run with: --machine arm4)
O0001 (where the arm stands at power-on it is stretched out)
G01 X200. F600. (expect moves: line X200 Y0)
X264. (expect moves: line X264 Y0)
X200. Y-50. (expect moves: line X200 Y-50)
X0 Y-264. (expect moves: line X0 Y-264)
M30
(finally machine X0 Y-264)

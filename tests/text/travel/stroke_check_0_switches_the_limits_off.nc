(run with: --machine laser3 --param stroke_check=0)
O1 (WCS-7)
G90 G01 X5000. F6000 (expect moves: line X5000)
M30

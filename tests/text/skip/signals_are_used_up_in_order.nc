(run with: --skip-at X=3 --skip-at X=7)
O1 (REF-5: two probing moves)
G90 G31 X10. F50 (expect moves: probe X3)
G31 X10. (expect moves: probe X7)
G31 X10. (expect moves: probe X10)
M30

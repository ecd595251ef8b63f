(run with: --skip-at X=7.2)
O1 (REF-5: X10. ends at 10)
G90 G31 X10. F50 (expect moves: probe X7.2)
G00 X10. (expect moves: rapid X10)
M30

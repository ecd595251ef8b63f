(run with: --skip-at X=6)
O1 (REF-5: 60 percent of the way)
G90 G31 X10. Y20. F50 (expect moves: probe X6 Y12)
#100=#5062 (expect #100=12)
M30

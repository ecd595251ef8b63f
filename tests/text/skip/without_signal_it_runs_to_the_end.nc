O1 (REF-5: #5061 is the end point)
G90 G31 X10. Y5. F50 (expect moves: probe X10 Y5)
#100=#5061 (expect #100=10)
#101=#5062 (expect #101=5)
M30

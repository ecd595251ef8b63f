(run with: --skip-at X=7.2)
O1 (REF-5: 7.2 of 10)
G91 G31 X10. F50 (expect moves: probe X7.2 F50)
#100=#5061 (expect #100=7.2)
X1. (expect moves: rapid X8.2)
#101=#5001 (expect #101=8.2)
M30

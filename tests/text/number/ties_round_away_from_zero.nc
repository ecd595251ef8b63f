O1 (NUM-14: 1.2345 becomes 1.235 though its double lies below)
#1=1.2345
G90 G00 X#1
#100=#5001 (expect #100=1.235)
X-#1
#101=#5001 (expect #101=-1.235)
M30

O1 (section 3.5: #2000 is write protected)
#2000=1 (expect alarm PS0116)
M30

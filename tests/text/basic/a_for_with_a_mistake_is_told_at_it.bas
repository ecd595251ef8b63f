print "first"
for i=1 to ' (expect alarm LB0003)
next
' (finally prints first)

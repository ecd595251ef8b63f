for i=1 to 0
y=5
if 1 then next
if y=0 then print "zero" else print "bad" ' (expect warning LW0001 at y)
' (finally prints zero)
' (finally y=0)

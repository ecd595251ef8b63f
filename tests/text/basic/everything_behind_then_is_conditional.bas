x=0
if 0 then x=1; x=2; print "no"
if 1 then x=3; y=4 else x=5
if 0 then x=6; else x=x+10; y=y+10
print x; y
' (finally prints 13 14)

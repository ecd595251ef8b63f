for x=0 to 100 step 0.1
next
if x=1001*0.1 then print "exact"
' (finally prints exact)

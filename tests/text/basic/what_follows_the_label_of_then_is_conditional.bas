if 0 then 100; print "no"
if 1 then 200; else print "bad"
print "bad"
200 print "good"
100 if 0 then 300 else 400
300 print "bad"
400 end
' (finally prints good)

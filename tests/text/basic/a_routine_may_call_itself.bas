d=0
gosub nest
print "depth"; d
end
nest:
 d=d+1
 if d<5 then gosub nest
 print d;
 return
' (finally prints 5 5 5 5 5 depth 5)
